#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// The text of the configuration FILE of `--calibrate FILE`, which will be written into. Throws InputError
/// (configuration) unless it is a valid configuration of landmark-localization: anything else, say a log, would be
/// lost. A file that does not exist begins as `initial`; without that, or without its folder, InputError (data).
[[nodiscard]] std::string readFileToCalibrate(const std::filesystem::path& file, std::string_view initial = {});
}  // namespace mrpt_ext
