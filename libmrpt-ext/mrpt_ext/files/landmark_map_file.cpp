#include "mrpt_ext/files/landmark_map_file.h"

#include <yaml-cpp/yaml.h>

#include <Eigen/Geometry>
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
constexpr const char* kTagCategory = "tag";
constexpr double kLeastHorizontal = 0.5;  ///< of a normal whose direction from above means something

/// [rad] from above; nothing for a normal that points up or down. `normal`: in the axes of a tag of this attitude.
std::optional<double> yawOf(const Eigen::Quaterniond& attitude, const Vector3d& normal)
{
  if (!(attitude.norm() > 0)) return std::nullopt;
  const Vector3d towards = attitude.normalized() * normal;
  if (!(towards.head<2>().norm() > kLeastHorizontal)) return std::nullopt;
  return std::atan2(towards.y(), towards.x());
}

/// Collects tags and refuses what no map can have.
class TagMap
{
 public:
  TagMap(const std::string& name, const RowLimit& limit) : name_(name), limit_(limit) {}

  void add(int id, const Vector3d& position, const std::optional<double>& yaw)
  {
    const std::string where = name_ + ": tag " + std::to_string(id);
    if (id < 0 || !seen_.insert(id).second) throw dataError(where + " is negative or occurs twice");
    if (!position.allFinite() || position.cwiseAbs().maxCoeff() > kLargestCoordinate)
      throw dataError(where + ": its position is not finite or far away, expected metres");
    if (landmarks_.size() == limit_.rows)
      throw dataError(name_ + ": more than " + std::to_string(limit_.rows) + " tags, expected no more" +
                      (limit_.set_by.empty() ? "" : ": set " + limit_.set_by));
    landmarks_.push_back({.id = id, .position = position, .category = kTagCategory, .yaw = yaw});
  }
  [[nodiscard]] LandmarkTable table() const
  {
    if (landmarks_.empty()) throw dataError(name_ + ": holds no tag with a position");
    return LandmarkTable(landmarks_);
  }

 private:
  const std::string& name_;
  const RowLimit& limit_;
  std::set<int> seen_;
  std::vector<Landmark> landmarks_;
};

/// Zero where a pose of WPILib has no rotation.
Eigen::Quaterniond attitudeIn(const nlohmann::json& pose)
{
  if (!pose.contains("rotation")) return {0, 0, 0, 0};
  const auto& q = pose.at("rotation").at("quaternion");
  return {q.at("W").get<double>(), q.at("X").get<double>(), q.at("Y").get<double>(), q.at("Z").get<double>()};
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }
}  // namespace

LandmarkTable parseFieldLayout(const std::string& text, const std::string& name, const RowLimit& limit)
{
  TagMap map(name, limit);
  try
  {
    const auto layout = nlohmann::json::parse(text);
    for (const auto& tag : layout.at("tags"))
    {
      const auto& at = tag.at("pose").at("translation");
      map.add(tag.at("ID").get<int>(), {at.at("x").get<double>(), at.at("y").get<double>(), at.at("z").get<double>()},
              yawOf(attitudeIn(tag.at("pose")), Vector3d::UnitX()));
    }
  }
  catch (const nlohmann::json::exception& error)
  {
    throw dataError(name + ": no WPILib field layout, expected tags with ID and pose (" + firstLine(error.what()) +
                    ")");
  }
  return map.table();
}

LandmarkTable parseTagBundle(const std::string& text, const std::string& name, const RowLimit& limit)
{
  TagMap map(name, limit);
  try
  {
    const YAML::Node bundles = YAML::Load(text)["tag_bundles"];
    if (!bundles || bundles.size() != 1)
      throw dataError(name + ": " + std::to_string(bundles ? bundles.size() : 0) +
                      " tag_bundles, expected one, whose frame is the map's");
    for (const YAML::Node& tag : bundles[0]["layout"])
      map.add(
          tag["id"].as<int>(), {tag["x"].as<double>(0), tag["y"].as<double>(0), tag["z"].as<double>(0)},
          yawOf({tag["qw"].as<double>(1), tag["qx"].as<double>(0), tag["qy"].as<double>(0), tag["qz"].as<double>(0)},
                Vector3d::UnitZ()));
  }
  catch (const YAML::Exception& error)
  {
    throw dataError(name + ":" + std::to_string(error.mark.line + 1) +
                    ": no tags.yaml of apriltag_ros, expected tag_bundles with a layout (" + error.msg + ")");
  }
  return map.table();
}

LandmarkTable readLandmarkMapFile(const std::filesystem::path& path, const RowLimit& limit)
{
  const std::string ending = path.extension().string();
  if (ending == ".json") return parseFieldLayout(readTextFile(path), path.string(), limit);
  if (ending == ".yaml" || ending == ".yml") return parseTagBundle(readTextFile(path), path.string(), limit);
  return readLandmarkCsv(path, limit);
}
}  // namespace mrpt_ext
