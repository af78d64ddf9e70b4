#pragma once

#include <cstdint>
#include <memory>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/localizers/filter_localizer.h"

namespace mrpt_ext
{
/// The reference engine: MRPT's own CMonteCarloLocalization2D over CLandmarkMap2D, with the same motion noise, the same
/// likelihood and the same extraction of modes as the batch engine, but without its initialization, recovery and
/// learned reliability. MRPT has one generator per thread, which cannot be reset completely: run every trial in a new
/// thread.
[[nodiscard]] std::unique_ptr<FilterLocalizer> makeMrptFilterLocalizer(const LocalizationConfig& config,
                                                                       const LandmarkTable& map, std::uint64_t seed,
                                                                       int trial);
}  // namespace mrpt_ext
