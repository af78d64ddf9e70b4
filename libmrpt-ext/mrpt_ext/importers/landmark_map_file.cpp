#include "mrpt_ext/importers/landmark_map_file.h"

#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <set>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/physical_limits.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kTagCategory = "tag";

/// Collects tags and refuses what no map can have.
class TagMap
{
 public:
  explicit TagMap(const fs::path& path) : path_(path) {}

  void add(int id, const Vector3d& position)
  {
    const std::string where = path_.string() + ": tag " + std::to_string(id);
    if (id < 0 || !seen_.insert(id).second) throw dataError(where + " is negative or occurs twice");
    if (!position.allFinite() || position.cwiseAbs().maxCoeff() > kLargestCoordinate)
      throw dataError(where + ": its position is not finite or far away, expected metres");
    landmarks_.push_back({.id = id, .position = position, .category = kTagCategory});
  }
  [[nodiscard]] LandmarkTable table() const
  {
    if (landmarks_.empty()) throw dataError(path_.string() + ": holds no tag with a position");
    return LandmarkTable(landmarks_);
  }

 private:
  fs::path path_;
  std::set<int> seen_;
  std::vector<Landmark> landmarks_;
};

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

LandmarkTable readWpilib(const fs::path& path)
{
  TagMap map(path);
  try
  {
    const auto layout = nlohmann::json::parse(readTextFile(path));
    for (const auto& tag : layout.at("tags"))
    {
      const auto& at = tag.at("pose").at("translation");
      map.add(tag.at("ID").get<int>(), {at.at("x").get<double>(), at.at("y").get<double>(), at.at("z").get<double>()});
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    throw dataError(path.string() + ": no WPILib field layout, expected tags with ID and pose (" +
                    firstLine(error.what()) + ")");
  }
  return map.table();
}

LandmarkTable readBundle(const fs::path& path)
{
  TagMap map(path);
  try
  {
    const YAML::Node bundles = YAML::Load(readTextFile(path))["tag_bundles"];
    if (!bundles || bundles.size() != 1)
      throw dataError(path.string() + ": " + std::to_string(bundles ? bundles.size() : 0) +
                      " tag_bundles, expected one, whose frame is the map's");
    for (const YAML::Node& tag : bundles[0]["layout"])
      map.add(tag["id"].as<int>(), {tag["x"].as<double>(0), tag["y"].as<double>(0), tag["z"].as<double>(0)});
  }
  catch (const YAML::Exception& error)
  {
    throw dataError(path.string() + ":" + std::to_string(error.mark.line + 1) +
                    ": no tags.yaml of apriltag_ros, expected tag_bundles with a layout (" + error.msg + ")");
  }
  return map.table();
}
}  // namespace

LandmarkTable readLandmarkMapFile(const fs::path& path)
{
  const std::string ending = path.extension().string();
  if (ending == ".json") return readWpilib(path);
  if (ending == ".yaml" || ending == ".yml") return readBundle(path);
  return readLandmarkCsv(path);
}
}  // namespace mrpt_ext
