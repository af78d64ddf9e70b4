#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/configuration/filter_engine.h"
#include "mrpt_ext/evaluation/convergence.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/frames/frame_synchronizer.h"
#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/localizers/running_fix_localizer.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
inline const std::string kExperimentSection = "LocalizationExperiment";  ///< of the .ini file

/// Keys of it with corrections of landmarks' places, along x and y.
inline const std::array<std::string, 2> kShiftKeys{"landmark_shift_x_m", "landmark_shift_y_m"};

inline constexpr double kRegionMargin = 3;             ///< [m] around the landmarks: where the robot may be
inline constexpr double kStepBudgetMs = 50;            ///< [ms] of a step of the particle filter
inline constexpr double kStartStdXy = 0.1;             ///< [m] of a known start
inline constexpr double kStartStdPhi = degToRad(5.0);  ///< [rad]
inline constexpr std::uint64_t kLandmarkMaps = 1;      ///< that a configuration declares for MRPT

/// What landmark-localization does, independent of where it was configured.
struct LocalizationConfig
{
  std::uint64_t seed = 1;
  int repetitions = 1;
  BiasModel biases;  ///< systematic errors that the filters estimate beside the pose
  ParticleFilterOptions filter;
  bool region_assumed = false;        ///< the box of possible positions is the map with kRegionMargin
  bool odometry_noise_stated = true;  ///< false: that of filter.motion is a default
  FilterEngine engine = FilterEngine::batch;
  int mrpt_algorithm = 0;  ///< PF_algorithm of the mrpt engine
  RunningFixOptions running_fix;
  FrameOptions frames;
  bool auto_calibrate = true;             ///< from a first pass over the log
  double step = 1;                        ///< [s] that a step of a log of steps counts where its stamps are no clock
  double join_window = 0;                 ///< [s]
  double seed_window = 3;                 ///< [s]
  double lateness = 0;                    ///< [s] live: a record may be this much older than the newest
  double step_budget_ms = kStepBudgetMs;  ///< of a step of the particle filter, in operations; 0: no limit
  double odometry_wait = 1;               ///< [s] live: that an estimate waits for odometry which reaches its time
  std::vector<std::string> methods;       ///< empty: all that the log has measurements for
  ConvergenceLimits limits;
  bool final_scene = false;
  std::size_t scene_every = 0;          ///< a scene of every N-th frame; 0: none
  std::size_t max_detections = 2000;    ///< of a frame
  std::size_t max_landmarks = 100'000;  ///< of the map
  /// [m] corrections of landmarks' places in the map, which configuredMap() has made.
  LandmarkValues landmark_shift_x, landmark_shift_y;
};

/// Reads the configuration; the map is needed for the default box of possible positions. Throws InputError
/// (configuration) for values that contradict each other.
[[nodiscard]] LocalizationConfig localizationConfig(const Settings& settings, const LandmarkTable& map);
}  // namespace mrpt_ext
