#include "mrpt_ext/frames/landmark_values.h"

#include <sstream>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
LandmarkValues landmarkValues(const Settings& settings, const std::string& section, const std::string& key)
{
  LandmarkValues values;
  if (!settings.hasValue(section, key)) return values;
  std::istringstream words(settings.text(section, key));
  for (std::string word; words >> word;)
  {
    const std::size_t colon = word.find(':');
    const auto id = parseInteger(word.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseNumber(word.substr(colon + 1));
    if (!id || !value) throw settings.errorAt(section, key, "expected id:value pairs such as 1:0.12 4:-0.05");
    if (!values.emplace(*id, *value).second)
      throw settings.errorAt(section, key, "landmark " + std::to_string(*id) + " occurs twice, expected it once");
  }
  return values;
}

double valueOf(const LandmarkValues& values, int id)
{
  const auto found = values.find(id);
  return found == values.end() ? 0 : found->second;
}
}  // namespace mrpt_ext
