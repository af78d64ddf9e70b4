#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "../integration/whole_runs.h"
#include "mrpt_ext/app/apps.h"

namespace mrpt_ext::testing
{
/// images2rawlog, in this process.
inline AppOutcome runImages(const Arguments& arguments)
{
  std::ostringstream out, err;
  const int code = runImages2Rawlog(arguments, out, err);
  return {code, out.str(), err.str()};
}

/// A folder of the shared scenes (LANDMARK_SCENES_DIR, default: beside the source tree); nothing when absent.
inline std::optional<std::filesystem::path> sharedScene(const std::string& name)
{
  const char* root = std::getenv("LANDMARK_SCENES_DIR");
  const std::filesystem::path folder =
      root ? std::filesystem::path(root) : std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "../shared/scenes";
  if (!std::filesystem::exists(folder / name)) return std::nullopt;
  return folder / name;
}
}  // namespace mrpt_ext::testing
