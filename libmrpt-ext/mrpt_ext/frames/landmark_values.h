#pragma once

#include <map>
#include <string>

#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// A value per landmark id.
using LandmarkValues = std::map<int, double>;

/// Reads a key of the form `1:0.12 4:-0.05`, separated by blanks; none where it is not set. Throws InputError
/// (configuration) with the line on anything else and on an id that occurs twice.
[[nodiscard]] LandmarkValues landmarkValues(const Settings& settings, const std::string& section,
                                            const std::string& key);

/// The value of a landmark, 0 when it has none.
[[nodiscard]] double valueOf(const LandmarkValues& values, int id);
}  // namespace mrpt_ext
