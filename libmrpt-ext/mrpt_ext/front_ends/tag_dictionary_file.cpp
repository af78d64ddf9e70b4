#include "mrpt_ext/front_ends/tag_dictionary_file.h"

#include <yaml-cpp/yaml.h>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
constexpr int kFewestCells = 3, kMostCells = 8, kMostMarkers = 20000;
}  // namespace

TagDictionary readTagDictionary(const std::filesystem::path& file)
{
  const auto error = [&](const std::string& what) { return configurationError(file.string() + ": " + what); };
  std::string text = readTextFile(file);
  // OpenCV writes "%YAML:1.0", which is no YAML.
  if (text.starts_with("%YAML")) text.erase(0, text.find('\n'));
  TagDictionary dictionary;
  try
  {
    const YAML::Node root = YAML::Load(text);
    dictionary.cells = root["markersize"].as<int>(0);
    const int markers = root["nmarkers"].as<int>(0);
    if (dictionary.cells < kFewestCells || dictionary.cells > kMostCells || markers < 1 || markers > kMostMarkers)
      throw error("expected markersize from 3 to 8 and nmarkers from 1 to 20000");
    const auto bits = static_cast<std::size_t>(dictionary.cells * dictionary.cells);
    for (int id = 0; id < markers; ++id)
    {
      const std::string name = "marker_" + std::to_string(id), cells = root[name].as<std::string>("");
      if (cells.size() != bits || cells.find_first_not_of("01") != std::string::npos)
        throw error(name + ": expected " + std::to_string(bits) + " cells, each 0 or 1");
      dictionary.codes.push_back(std::stoull(cells, nullptr, 2));
    }
  }
  catch (const YAML::Exception& damage)
  {
    throw error("no dictionary of tags, expected YAML with nmarkers, markersize, marker_0 ... (" + damage.msg + ")");
  }
  return dictionary;
}
}  // namespace mrpt_ext
