#include "mrpt_ext/importers/sensor_poses.h"

#include <cmath>
#include <set>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
/// The span of a scanner's beams; nothing for other sensors.
std::optional<BeamSpan> beamSpan(const TextTable& table, std::size_t row)
{
  const auto first = table.findColumn("first_bearing_deg"), last = table.findColumn("last_bearing_deg");
  if (!first && !last) return std::nullopt;
  const auto from = table.optionalNumber(row, table.column("first_bearing_deg"));
  const auto to = table.optionalNumber(row, table.column("last_bearing_deg"));
  if (!from && !to) return std::nullopt;
  if (!from || !to || *from == *to || std::abs(*from) > 360 || std::abs(*to - *from) > 360)
    throw table.errorAt(row, "expected both first_bearing_deg and last_bearing_deg, at most a full turn apart");
  return BeamSpan{degToRad(*from), degToRad(*to)};
}
}  // namespace

std::map<std::string, SensorPose> readSensorPoses(const std::filesystem::path& path)
{
  const TextTable table(path, {});
  table.expectOnlyColumns({"sensor", "x", "y", "z", "yaw_deg", "first_bearing_deg", "last_bearing_deg"});
  const std::size_t sensor = table.column("sensor"), x = table.column("x"), y = table.column("y"),
                    z = table.column("z"), yaw = table.column("yaw_deg");
  std::map<std::string, SensorPose> poses;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const SensorPose pose{{table.coordinate(row, x), table.coordinate(row, y), wrap(degToRad(table.number(row, yaw)))},
                          table.coordinate(row, z),
                          beamSpan(table, row)};
    const std::string& label = table.text(row, sensor);
    if (label.empty()) throw table.errorAt(row, "no sensor, expected its label");
    if (!poses.emplace(label, pose).second)
      throw table.errorAt(row, "sensor '" + label + "' occurs twice, expected one row per sensor");
  }
  return poses;
}

void setRobotFrame(Recording& recording, const SensorPose& frame)
{
  const Pose2 T_frame_robot = inverse(frame.T_robot_sensor);
  for (Record& record : recording.records)
  {
    if (auto* odometry = std::get_if<OdometryRecord>(&record))
      odometry->pose = compose(odometry->pose, frame.T_robot_sensor);
    if (auto* reading = std::get_if<Reading>(&record))
      reading->T_robot_sensor = compose(T_frame_robot, reading->T_robot_sensor);
    if (auto* scan = std::get_if<RangeScan>(&record))
      scan->T_robot_sensor = compose(T_frame_robot, scan->T_robot_sensor);
  }
}

void mountSensors(Recording& recording, const std::map<std::string, SensorPose>& poses,
                  const std::filesystem::path& path)
{
  std::set<std::string> unused;
  for (const auto& [label, pose] : poses) unused.insert(label);
  for (Record& record : recording.records)
  {
    if (const auto* scan = std::get_if<RangeScan>(&record)) unused.erase(scan->sensor);
    auto* reading = std::get_if<Reading>(&record);
    if (!reading) continue;
    const auto pose = poses.find(reading->sensor);
    if (pose == poses.end())
      throw dataError(path.string() + ": no row for sensor '" + reading->sensor +
                      "' of the detections, expected its pose");
    reading->T_robot_sensor = pose->second.T_robot_sensor;
    reading->sensor_height = pose->second.height;
    unused.erase(reading->sensor);
  }
  for (const std::string& label : unused) recording.notes.push_back("sensor '" + label + "' has no detections");
}
}  // namespace mrpt_ext
