#pragma once

#include <cstdint>
#include <memory>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/localizers/filter_localizer.h"

namespace mrpt_ext
{
/// The reference engine: MRPT's own CMonteCarloLocalization2D over CLandmarkMap2D, with the same motion noise, the same
/// likelihood and the same judgement of modes as the batch engine, but none of its seeding, recovery or learned
/// reliability. MRPT's generator is one per thread and cannot be reset completely: run every trial in a fresh thread.
[[nodiscard]] std::unique_ptr<FilterLocalizer> makeMrptFilterLocalizer(const LocalizationConfig& config,
                                                                       const LandmarkTable& map, std::uint64_t seed,
                                                                       int trial);
}  // namespace mrpt_ext
