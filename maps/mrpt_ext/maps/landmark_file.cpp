#include "mrpt_ext/maps/landmark_file.h"

#include <cstdlib>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
std::filesystem::path findLandmarkFile(const std::string& name)
{
  if (name.empty()) throw configurationError("landmarks_file: expected the path of a map .csv, found nothing");
  if (std::filesystem::is_regular_file(name)) return name;
  const char* folder = std::getenv("LANDMARK_MAP_DIR");
  if (folder && std::filesystem::is_regular_file(std::filesystem::path(folder) / name))
    return std::filesystem::path(folder) / name;
  throw configurationError("landmarks_file = " + name + ": no such file in " +
                           std::filesystem::current_path().string() +
                           (folder ? " or LANDMARK_MAP_DIR = " + std::string(folder) : " (LANDMARK_MAP_DIR not set)"));
}
}  // namespace mrpt_ext
