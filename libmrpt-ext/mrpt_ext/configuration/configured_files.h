#pragma once

#include <filesystem>
#include <string>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
inline const std::string kMapSection = "MetricMap_landmarkMap2D_00_creationOpts";  ///< of the .ini file: MRPT's name

/// The existing file that a key names. Throws InputError; `option` is what the command line has in the place of the
/// key.
[[nodiscard]] std::filesystem::path requiredPath(const Settings& settings, const std::string& section,
                                                 const std::string& key, const std::string& option);

/// `map` with its landmarks where the configuration corrects them to be (kShiftKeys). Throws InputError for a landmark
/// that is not there.
[[nodiscard]] LandmarkTable correctedMap(const Settings& settings, const LandmarkTable& map);

/// The map that a configuration names, within its limit, corrected. Throws InputError, also when it holds no landmark.
[[nodiscard]] LandmarkTable configuredMap(const Settings& settings);
}  // namespace mrpt_ext
