#include "mrpt_ext/configuration/configured_files.h"

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
std::filesystem::path requiredPath(const Settings& settings, const std::string& section, const std::string& key,
                                   const std::string& option)
{
  if (settings.hasValue(section, key)) return settings.existingPath(section, key);
  throw configurationError(settings.file().string() + ": [" + section + "] " + key + " is not set, set it or give " +
                           option);
}

LandmarkTable configuredMap(const Settings& settings)
{
  const auto path = requiredPath(settings, kMapSection, "landmarks_file", "--map FILE");
  const auto most = static_cast<std::size_t>(settings.integer(kExperimentSection, "max_landmarks"));
  LandmarkTable map = readLandmarkMapFile(path, {most, "[" + kExperimentSection + "] max_landmarks"});
  if (map.empty()) throw configurationError(path.string() + ": holds no landmark, at least one is needed");
  return map;
}
}  // namespace mrpt_ext
