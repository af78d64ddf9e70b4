#pragma once

#include <string>
#include <vector>

#include "frame_sequence.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/localizers/particle_filter_localizer.h"

namespace mrpt_ext
{
/// A shipped scenario: ini/landmark-simulator/<name>.ini simulated and synchronized into frames as configured in
/// ini/landmark-localization/<name>.ini, without files in between.
struct FilterScenario
{
  LandmarkTable map;
  Trajectory truth;
  LocalizationConfig config;
  testing::FrameSequence sequence;
};

/// `changes`: "Section.key=value" each, as for --set.
[[nodiscard]] FilterScenario playScenario(const std::string& name, std::uint64_t seed,
                                          const std::vector<std::string>& simulator_changes = {},
                                          const std::vector<std::string>& localization_changes = {});

/// The filter and the truth after one frame.
struct FilterSample
{
  double time = 0;  ///< [s] since the start
  const Frame* frame = nullptr;
  Pose2 truth;
  FilterStep step;
  Vector3d error{0, 0, 0};  ///< of the best mode

  [[nodiscard]] const Mode& best() const { return step.modes.modes.front(); }
  [[nodiscard]] double distance() const { return error.head<2>().norm(); }
  /// Normalised squared error of position and heading (three degrees of freedom), and of the position alone (two).
  [[nodiscard]] double nees() const;
  [[nodiscard]] double positionNees() const;
};

/// The filter over all frames that have a true pose. The frames belong to the scenario.
[[nodiscard]] std::vector<FilterSample> runFilter(const FilterScenario& scenario, std::uint64_t seed);

/// Number of runs of a study: `full`, or the value of the environment variable STUDY_RUNS.
[[nodiscard]] int studyRuns(int full);
/// Random seed of its run number `run`, counted from 0: the first has 1, or the value of the environment variable
/// STUDY_FIRST_SEED, and each one more.
[[nodiscard]] std::uint64_t studySeed(int run);
}  // namespace mrpt_ext
