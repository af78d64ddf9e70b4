#include "mrpt_ext/importers/sensor_poses.h"

#include <set>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
std::map<std::string, SensorPose> readSensorPoses(const std::filesystem::path& path)
{
  const TextTable table(path, {});
  table.expectOnlyColumns({"sensor", "x", "y", "z", "yaw_deg"});
  const std::size_t sensor = table.column("sensor"), x = table.column("x"), y = table.column("y"),
                    z = table.column("z"), yaw = table.column("yaw_deg");
  std::map<std::string, SensorPose> poses;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const SensorPose pose{{table.coordinate(row, x), table.coordinate(row, y), wrap(degToRad(table.number(row, yaw)))},
                          table.coordinate(row, z)};
    const std::string& label = table.text(row, sensor);
    if (label.empty()) throw table.errorAt(row, "no sensor, expected its label");
    if (!poses.emplace(label, pose).second)
      throw table.errorAt(row, "sensor '" + label + "' occurs twice, expected one row per sensor");
  }
  return poses;
}

void mountSensors(Recording& recording, const std::filesystem::path& path)
{
  const auto poses = readSensorPoses(path);
  std::set<std::string> unused;
  for (const auto& [label, pose] : poses) unused.insert(label);
  for (Record& record : recording.records)
  {
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
