#pragma once

#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// The text of the configuration FILE of `--calibrate FILE`, which will be written into. Throws InputError
/// (configuration) unless it is a valid configuration of landmark-localization: anything else, say a log, would be
/// lost.
[[nodiscard]] std::string readFileToCalibrate(const std::filesystem::path& file);
}  // namespace mrpt_ext
