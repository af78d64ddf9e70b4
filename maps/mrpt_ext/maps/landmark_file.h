#pragma once

#include <filesystem>
#include <string>

namespace mrpt_ext
{
/// Finds the file named by `landmarks_file`: an absolute path as it is; a relative one in the working directory, then
/// in the folder that the environment variable LANDMARK_MAP_DIR names. (MRPT's applications pass the keys of
/// a map without the path of the .ini, so that it cannot be relative to that.) Throws InputError (configuration).
[[nodiscard]] std::filesystem::path findLandmarkFile(const std::string& name);
}  // namespace mrpt_ext
