#include "mrpt_ext/configuration/configured_files.h"

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/sensor_sections.h"
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

LandmarkTable correctedMap(const Settings& settings, const LandmarkTable& map)
{
  std::vector<Landmark> landmarks = map.all();
  for (Eigen::Index axis = 0; axis < 2; ++axis)
  {
    const std::string& key = kShiftKeys[static_cast<std::size_t>(axis)];
    for (const auto& [id, shift] : landmarkValues(settings, kExperimentSection, key))
    {
      const std::optional<std::size_t> number = map.indexOf(id);
      if (!number)
        throw settings.errorAt(kExperimentSection, key,
                               "landmark " + std::to_string(id) + " is not in the map, expected ids of its landmarks");
      landmarks[*number].position[axis] += shift;
    }
  }
  return LandmarkTable(std::move(landmarks));
}

LandmarkTable configuredMap(const Settings& settings)
{
  const auto path = requiredPath(settings, kMapSection, "landmarks_file", "--map FILE");
  const auto most = static_cast<std::size_t>(settings.integer(kExperimentSection, "max_landmarks"));
  LandmarkTable map = readLandmarkMapFile(path, {most, "[" + kExperimentSection + "] max_landmarks"});
  if (map.empty()) throw configurationError(path.string() + ": holds no landmark, at least one is needed");
  return correctedMap(settings, map);
}
}  // namespace mrpt_ext
