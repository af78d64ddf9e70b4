#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>

#include "filter_scenario.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/localizers/kalman_localizer.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kTruthStream = 17;

/// One systematic error: its prior, the key that simulates it, and what that key is for an error.
struct SimulatedBias
{
  BiasKind kind;
  std::string prior, key;
  double std;
  double (*value)(double error);
};

const std::vector<SimulatedBias> kBiases{
    {BiasKind::distance_scale, "odometry_distance_scale_std", "Odometry.scale_error", 0.03,
     [](double e) { return 1 / (1 + e) - 1; }},
    {BiasKind::rotation_scale, "odometry_rotation_scale_std", "Odometry.rotation_scale_error", 0.03,
     [](double e) { return 1 / (1 + e) - 1; }},
    {BiasKind::range_scale, "range_scale_std", "Sensor_camera.scale_range", 0.03, [](double e) { return 1 + e; }},
    {BiasKind::range_offset, "range_offset_std_m", "Sensor_camera.bias_range_m", 0.1, [](double e) { return e; }}};

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

std::size_t indexOf(const BiasModel& model, BiasKind kind)
{
  const auto found =
      std::find_if(model.begin(), model.end(), [&](const BiasState& state) { return state.kind == kind; });
  return static_cast<std::size_t>(found - model.begin());
}

void runBiases(std::ostream& out)
{
  const std::vector<double> times{15, 30, 60, 120, 175};
  using Tallies = std::vector<std::vector<BiasTally>>;
  Tallies tallies(kBiases.size(), std::vector<BiasTally>(times.size())), of_bank = tallies;
  const int runs = studyRuns(100);
  for (int k = 0; k < runs; ++k)
  {
    const auto seed = static_cast<std::uint64_t>(k) + 1;
    RandomStream random(seed, kTruthStream);
    std::vector<std::string> simulated{"RandomErrors.drift_deg_s=0",  "RandomErrors.arc_turn_loss=0",
                                       "RandomErrors.noise_factor=1", "RandomErrors.slips_per_minute=0",
                                       "RandomErrors.delay_s=0",      "RandomErrors.lever_arm_m=0"};
    std::vector<std::string> stated;
    std::vector<double> truth;
    for (const SimulatedBias& bias : kBiases)
    {
      truth.push_back(bias.std * random.gaussian());
      simulated.push_back(bias.key + "=" + std::to_string(bias.value(truth.back())));
      stated.push_back("Bias." + bias.prior + "=" + std::to_string(bias.std));
    }
    const FilterScenario scenario = playScenario("bad-odometry", seed, simulated, stated);
    const BiasModel& model = scenario.config.filter.biases;
    std::size_t next = 0;
    for (const FilterSample& sample : runFilter(scenario, seed))
    {
      if (next == times.size() || sample.time < times[next] || sample.step.biases.empty()) continue;
      for (std::size_t b = 0; b < kBiases.size(); ++b)
        add(sample.step.biases[indexOf(model, kBiases[b].kind)], truth[b], tallies[b][next]);
      ++next;
    }
    KalmanBankOptions like{.motion = scenario.config.filter.motion, .biases = model};
    KalmanLocalizer bank("kalman_filter_bank", like, scenario.map, scenario.config.filter.region,
                         scenario.config.seed_window, std::make_shared<const GlobalPoseSearch>(scenario.map));
    next = 0;
    for (const Frame& frame : scenario.sequence.frames)
    {
      (void)bank.process(frame);
      if (next == times.size() || frame.time - scenario.truth.front().time < times[next] ||
          bank.bank().hypotheses().empty())
        continue;
      const KalmanState& state = bank.bank().hypotheses().front().state;
      for (std::size_t b = 0; b < kBiases.size(); ++b)
      {
        const auto at = static_cast<Eigen::Index>(3 + indexOf(model, kBiases[b].kind));
        add({state.mean[at], std::sqrt(state.covariance(at, at))}, truth[b], of_bank[b][next]);
      }
      ++next;
    }
  }
  const auto print = [&](const Tallies& of)
  {
    out << "| error | after | runs | scatter | stated | scatter / stated of each |\n|---|---|---|---|---|---|\n";
    for (std::size_t b = 0; b < kBiases.size(); ++b)
      for (std::size_t t = 0; t < times.size(); ++t)
      {
        const BiasTally& tally = of[b][t];
        out << "| " << kBiases[b].prior << " | " << times[t] << " s | " << tally.squares.size() << " | "
            << std::setprecision(3) << rootMean(tally.errors) << " | " << mean(tally.deviations) << " | "
            << rootMean(tally.squares) << " |\n";
      }
  };
  print(tallies);
  print(of_bank);
}

const RegisterStudy kBiasesStudy(
    "filter_biases", "Systematic errors estimated with the pose: do the stated deviations agree with truth?",
    runBiases);
}  // namespace
}  // namespace mrpt_ext
