#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/convergence.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/frames/frame_synchronizer.h"
#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/localizers/running_fix_localizer.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
enum class FilterEngine
{
  batch,  ///< our particle filter
  mrpt    ///< MRPT's CMonteCarloLocalization2D, the reference
};

/// What landmark-localization does, independent of where it was configured.
struct LocalizationConfig
{
  BiasModel biases;  ///< systematic errors that the filters estimate beside the pose
  ParticleFilterOptions filter;
  FilterEngine engine = FilterEngine::batch;
  int mrpt_algorithm = 0;  ///< PF_algorithm of the mrpt engine
  RunningFixOptions running_fix;
  FrameOptions frames;
  double join_window = 0;            ///< [s]
  double seed_window = 3;            ///< [s]
  std::vector<std::string> methods;  ///< empty: all that the log gives measurements for
  ConvergenceLimits limits;
  bool final_scene = false;
  std::size_t scene_every = 0;  ///< a scene of every so many frames; 0: none
};

/// Reads the configuration; the map is needed for the default box of possible positions. Throws InputError
/// (configuration) for values that contradict each other.
[[nodiscard]] LocalizationConfig localizationConfig(const Settings& settings, const LandmarkTable& map);

/// Words separated by blanks or commas.
[[nodiscard]] std::vector<std::string> words(const std::string& text);
}  // namespace mrpt_ext
