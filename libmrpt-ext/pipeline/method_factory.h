#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mrpt_ext/localizers/filter_localizer.h"
#include "mrpt_ext/localizers/localizer.h"
#include "mrpt_ext/pipeline/localization_config.h"

namespace mrpt_ext
{
/// The methods of one trial. The filter, when it runs, is the first; it is owned by `localizers` like all others.
struct Methods
{
  std::vector<std::unique_ptr<Localizer>> localizers;
  FilterLocalizer* filter = nullptr;
};

/// Builds the methods named in the configuration, or all for which the frames hold measurements. Throws InputError
/// (configuration) for an unknown name.
[[nodiscard]] Methods makeMethods(const LocalizationConfig& config, const LandmarkTable& map,
                                  const FrameSequence& sequence, std::uint64_t seed, int trial);
}  // namespace mrpt_ext
