#include "filter_scenario.h"

#include <Eigen/LU>
#include <cstdlib>

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/configuration/simulator_config.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/settings/settings.h"
#include "simulated_recording.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMaxGap = 0.5;  // [s] of the truth

std::string shipped(const std::string& app, const std::string& name)
{
  return std::string(MRPT_EXT_SOURCE_DIR) + "/ini/" + app + "/" + name + ".ini";
}
}  // namespace

FilterScenario playScenario(const std::string& name, std::uint64_t seed,
                            const std::vector<std::string>& simulator_changes,
                            const std::vector<std::string>& localization_changes)
{
  Settings simulator = Settings::load(shipped("landmark-simulator", name), simulatorKeys(), simulator_changes);
  simulator.set("Simulation", "random_seed", std::to_string(seed), "seed");
  const Recording recording = testing::simulate(readScenario(simulator));
  const Settings settings =
      Settings::load(shipped("landmark-localization", name), localizationKeys(), localization_changes);
  FilterScenario scenario{recording.map, recording.truth, localizationConfig(settings, recording.map), {}};
  scenario.sequence = testing::buildFrames(recording.records, scenario.map, scenario.config.frames);
  return scenario;
}

double FilterSample::nees() const { return error.dot(best().pose.covariance.inverse() * error); }

double FilterSample::positionNees() const
{
  const Matrix2d C = best().pose.covariance.topLeftCorner<2, 2>();
  return error.head<2>().dot(C.inverse() * error.head<2>());
}

std::vector<FilterSample> runFilter(const FilterScenario& scenario, std::uint64_t seed)
{
  ParticleFilterLocalizer filter(scenario.config.filter, scenario.map, scenario.config.seed_window, seed);
  std::vector<FilterSample> samples;
  for (const Frame& frame : scenario.sequence.frames)
  {
    (void)filter.process(frame);
    const auto truth = interpolate(scenario.truth, frame.time, kMaxGap);
    if (!truth || filter.lastStep().modes.modes.empty()) continue;
    FilterSample sample{frame.time - scenario.truth.front().time, &frame, truth->pose, filter.lastStep()};
    sample.error = sample.best().pose.mean.vector() - sample.truth.vector();
    sample.error.z() = wrap(sample.error.z());
    samples.push_back(std::move(sample));
  }
  return samples;
}

int studyRuns(int full)
{
  const char* wanted = std::getenv("STUDY_RUNS");
  return wanted ? std::max(1, std::atoi(wanted)) : full;
}

std::uint64_t studySeed(int run)
{
  const char* wanted = std::getenv("STUDY_FIRST_SEED");
  const std::uint64_t first = wanted ? std::strtoull(wanted, nullptr, 10) : 1;
  return first + static_cast<std::uint64_t>(run);
}
}  // namespace mrpt_ext
