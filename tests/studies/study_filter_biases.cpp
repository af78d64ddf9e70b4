#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <numeric>

#include "filter_scenario.h"
#include "mrpt_ext/geometry/bias_units.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/localizers/kalman_localizer.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kTruthStream = 17;
const std::vector<double> kTimes{15, 30, 60, 120, 175};  // [s]

/// The systematic errors of a run, by kind.
using Errors = std::map<BiasKind, double>;

/// One of them: its prior deviation, the key that simulates it, and what that key is. The simulator states what
/// odometry measures of the truth, the filter what is true of the measured; the last key is per true metre or second.
struct SimulatedBias
{
  BiasKind kind;
  double std;
  std::string key;
  double (*value)(const Errors& of);
};

double measuredTurns(const Errors& of) { return 1 / (1 + of.at(BiasKind::rotation_scale)); }

const std::vector<SimulatedBias> kBiases{
    {BiasKind::distance_scale, 0.03, "Odometry.scale_error",
     [](const Errors& of) { return 1 / (1 + of.at(BiasKind::distance_scale)) - 1; }},
    {BiasKind::rotation_scale, 0.03, "Odometry.rotation_scale_error",
     [](const Errors& of) { return measuredTurns(of) - 1; }},
    {BiasKind::arc_scale, 0.05, "Odometry.arc_scale_error",
     [](const Errors& of)
     { return 1 / (1 + of.at(BiasKind::rotation_scale) + of.at(BiasKind::arc_scale)) - measuredTurns(of); }},
    {BiasKind::veer, degToRad(1.0), "Odometry.veer_deg_per_m",
     [](const Errors& of) { return radToDeg(of.at(BiasKind::veer)) / (1 + of.at(BiasKind::distance_scale)); }},
    {BiasKind::drift, degToRad(0.2), "Odometry.drift_deg_s",
     [](const Errors& of) { return -radToDeg(of.at(BiasKind::drift)) * measuredTurns(of); }},
    {BiasKind::range_scale, 0.03, "Sensor_camera.scale_range",
     [](const Errors& of) { return 1 + of.at(BiasKind::range_scale); }},
    {BiasKind::range_offset, 0.1, "Sensor_camera.bias_range_m",
     [](const Errors& of) { return of.at(BiasKind::range_offset); }},
    {BiasKind::bearing_offset, degToRad(2.0), "Sensor_camera.bias_bearing_deg",
     [](const Errors& of) { return radToDeg(of.at(BiasKind::bearing_offset)); }}};

/// Of [Bias].
std::string priorKey(const BiasUnit& unit) { return std::string(unit.name) + "_std" + unit.suffix; }

/// The errors of a run in stated deviations, and the stated deviations, at some time.
struct BiasTally
{
  std::vector<double> squares, deviations, errors;
};

void add(const BiasEstimate& estimate, double truth, BiasTally& tally)
{
  tally.squares.push_back(square((estimate.mean - truth) / estimate.std));
  tally.deviations.push_back(estimate.std);
  tally.errors.push_back(square(estimate.mean - truth));
}

double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

double rootMean(const std::vector<double>& squares) { return std::sqrt(mean(squares)); }

using Tallies = std::vector<std::vector<BiasTally>>;  // by error and time

/// A drive whose odometry and ranges err as drawn from the stated priors; white noise beside that.
struct ErringDrive
{
  FilterScenario scenario;
  Errors truth;

  [[nodiscard]] std::size_t indexOf(std::size_t b) const
  {
    const BiasModel& model = scenario.config.filter.biases;
    const auto found =
        std::find_if(model.begin(), model.end(), [&](const BiasState& state) { return state.kind == kBiases[b].kind; });
    return static_cast<std::size_t>(found - model.begin());
  }
};

ErringDrive drive(std::uint64_t seed)
{
  RandomStream random(seed, kTruthStream);
  std::vector<std::string> simulated{"RandomErrors.drift_deg_s=0",  "RandomErrors.arc_turn_loss=0",
                                     "RandomErrors.noise_factor=1", "RandomErrors.slips_per_minute=0",
                                     "RandomErrors.delay_s=0",      "RandomErrors.lever_arm_m=0"};
  std::vector<std::string> stated;
  Errors truth;
  for (const SimulatedBias& bias : kBiases) truth[bias.kind] = bias.std * random.gaussian();
  for (const SimulatedBias& bias : kBiases)
  {
    const BiasUnit& unit = unitOf(bias.kind);
    simulated.push_back(bias.key + "=" + std::to_string(bias.value(truth)));
    stated.push_back("Bias." + priorKey(unit) + "=" + std::to_string(bias.std * unit.factor));
  }
  return {playScenario("bad-odometry", seed, simulated, stated), truth};
}

void addParticleFilter(const ErringDrive& drive, std::uint64_t seed, Tallies& tallies)
{
  std::size_t next = 0;
  for (const FilterSample& sample : runFilter(drive.scenario, seed))
  {
    if (next == kTimes.size() || sample.time < kTimes[next] || sample.step.biases.empty()) continue;
    for (std::size_t b = 0; b < kBiases.size(); ++b)
      add(sample.step.biases[drive.indexOf(b)], drive.truth.at(kBiases[b].kind), tallies[b][next]);
    ++next;
  }
}

void addKalmanBank(const ErringDrive& drive, Tallies& tallies)
{
  const FilterScenario& scenario = drive.scenario;
  const KalmanBankOptions options{.motion = scenario.config.filter.motion, .biases = scenario.config.filter.biases};
  KalmanLocalizer localizer("kalman_filter_bank", options, scenario.map, scenario.config.filter.region,
                            scenario.config.seed_window, std::make_shared<const GlobalPoseSearch>(scenario.map));
  std::size_t next = 0;
  for (const Frame& frame : scenario.sequence.frames)
  {
    (void)localizer.process(frame);
    const KalmanHypotheses& hypotheses = localizer.bank().hypotheses();
    if (next == kTimes.size() || frame.time - scenario.truth.front().time < kTimes[next] || hypotheses.empty())
      continue;
    const KalmanState& state = hypotheses.front().state;
    for (std::size_t b = 0; b < kBiases.size(); ++b)
    {
      const auto at = static_cast<Eigen::Index>(3 + drive.indexOf(b));
      add({state.mean[at], std::sqrt(state.covariance(at, at))}, drive.truth.at(kBiases[b].kind), tallies[b][next]);
    }
    ++next;
  }
}

void print(std::ostream& out, const std::string& method, const Tallies& tallies)
{
  for (std::size_t b = 0; b < kBiases.size(); ++b)
    for (std::size_t t = 0; t < kTimes.size(); ++t)
    {
      const BiasTally& tally = tallies[b][t];
      const BiasUnit& unit = unitOf(kBiases[b].kind);
      out << "| " << method << " | " << priorKey(unit) << " | " << kTimes[t] << " s | " << tally.squares.size() << " | "
          << std::setprecision(3) << unit.factor * rootMean(tally.errors) << " | "
          << unit.factor * mean(tally.deviations) << " | " << rootMean(tally.squares) << " |\n";
    }
}

void runBiases(std::ostream& out)
{
  Tallies filter(kBiases.size(), std::vector<BiasTally>(kTimes.size())), bank = filter;
  const int runs = studyRuns(100);
  for (int k = 0; k < runs; ++k)
  {
    const std::uint64_t seed = studySeed(k);
    const ErringDrive erring = drive(seed);
    addParticleFilter(erring, seed, filter);
    addKalmanBank(erring, bank);
  }
  out << "| method | error | after | runs | scatter | stated | RMS error in stated deviations |\n"
         "|---|---|---|---|---|---|---|\n";
  print(out, "particle_filter", filter);
  print(out, "kalman_filter_bank", bank);
}

const RegisterStudy kBiasesStudy(
    "filter_biases", "Systematic errors estimated with the pose: do the stated deviations agree with truth?",
    runBiases);
}  // namespace
}  // namespace mrpt_ext
