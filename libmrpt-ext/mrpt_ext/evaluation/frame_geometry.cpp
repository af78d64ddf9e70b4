#include "mrpt_ext/evaluation/frame_geometry.h"

#include <algorithm>
#include <set>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
/// Collects the directions and distances of one frame.
class GeometryCollector
{
 public:
  GeometryCollector(const LandmarkTable& map, std::optional<TimedPose> truth) : map_(map), truth_(truth) {}

  void add(const Pose2& T_robot_sensor, int id, std::optional<double> bearing, std::optional<double> range)
  {
    if (id != kNoId && !ids_.insert(id).second) return;
    ++count_;
    const auto known = fromMap(T_robot_sensor, id);
    if (bearing)
      directions_.push_back(*bearing + T_robot_sensor.phi);
    else if (known)
      directions_.push_back(std::atan2(known->y(), known->x()));
    if (range)
      distances_.push_back(*range);
    else if (known)
      distances_.push_back(known->norm());
  }

  [[nodiscard]] FrameGeometry at(double time) const
  {
    FrameGeometry geometry{time, count_, {}, median(distances_)};
    if (directions_.size() > 1) geometry.spread = angularSpread(directions_);
    return geometry;
  }

 private:
  /// The landmark from the sensor, robot axes.
  [[nodiscard]] std::optional<Vector2d> fromMap(const Pose2& T_robot_sensor, int id) const
  {
    const auto index = map_.indexOf(id);
    if (!index || !truth_ || !truth_->heading_known) return std::nullopt;
    const Vector2d landmark = map_[*index].position.head<2>();
    return Vector2d(transform(inverse(truth_->pose), landmark) - T_robot_sensor.position());
  }

  const LandmarkTable& map_;
  std::optional<TimedPose> truth_;
  std::set<int> ids_;
  std::size_t count_ = 0;
  std::vector<double> directions_, distances_;
};
}  // namespace

double angularSpread(std::vector<double> directions)
{
  if (directions.size() < 2) return 0;
  for (double& direction : directions) direction = wrap(direction);
  std::sort(directions.begin(), directions.end());
  double widest_gap = directions.front() + kTwoPi - directions.back();
  for (std::size_t i = 1; i < directions.size(); ++i)
    widest_gap = std::max(widest_gap, directions[i] - directions[i - 1]);
  return kTwoPi - widest_gap;
}

std::optional<FrameGeometry> frameGeometry(const Frame& frame, const LandmarkTable& map, const Trajectory& truth,
                                           double max_gap)
{
  GeometryCollector collector(map, interpolate(truth, frame.time, max_gap));
  for (const Reading& reading : frame.readings)
    for (const Detection& detection : reading.detections)
      collector.add(reading.T_robot_sensor, detection.id, detection.bearing, detection.range);
  for (const RunningFixReading& fix : frame.fixes)
    collector.add(fix.T_robot_sensor, fix.id, fix.second_bearing, fix.second_range);
  const FrameGeometry geometry = collector.at(frame.time);
  return geometry.landmarks > 0 ? std::optional(geometry) : std::nullopt;
}
}  // namespace mrpt_ext
