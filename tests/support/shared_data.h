#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace mrpt_ext
{
/// A file or folder of the shared recordings (LANDMARK_DATA_DIR, default: beside the source tree); nothing when absent.
inline std::optional<std::filesystem::path> sharedData(const std::string& name)
{
  const char* root = std::getenv("LANDMARK_DATA_DIR");
  const std::filesystem::path folder =
      root ? std::filesystem::path(root) : std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::exists(folder / name)) return std::nullopt;
  return folder / name;
}
}  // namespace mrpt_ext
