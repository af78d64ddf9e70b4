#include "mrpt_ext/simulation/running_fix_simulator.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/simulation/rounding.h"

namespace mrpt_ext
{
RunningFixSimulator::RunningFixSimulator(const SimulatedSensor& sensor, const RobotPath& path,
                                         const SimulatedOdometry& odometry, RandomStream random)
    : sensor_(sensor), path_(path), odometry_(odometry), random_(random)
{
  sensor_.sees_objects = false;
}

std::optional<RunningFixReading> RunningFixSimulator::measure(double time, const Pose2& robot,
                                                              const std::vector<SceneFeature>& features)
{
  std::vector<VisibleFeature> visible = visibleFeatures(sensor_, robot, features);
  std::erase_if(visible, [&](const VisibleFeature&) { return !random_.chance(sensor_.detection_probability); });
  const bool far_enough = first_ && path_.lengthAt(time) - path_.lengthAt(first_->time) >= sensor_.fix_distance;
  if (!first_ || visible.empty())
  {
    begin(time, visible);
    return std::nullopt;
  }
  const auto again = std::find_if(visible.begin(), visible.end(),
                                  [&](const VisibleFeature& feature) { return feature.feature == first_->feature; });
  if (again == visible.end()) begin(time, visible);
  if (again == visible.end() || !far_enough) return std::nullopt;
  const auto fix = finish(time, *again, features);
  first_.reset();
  return fix;
}

void RunningFixSimulator::begin(double time, const std::vector<VisibleFeature>& visible)
{
  first_.reset();
  const auto nearest =
      std::min_element(visible.begin(), visible.end(),
                       [](const VisibleFeature& a, const VisibleFeature& b) { return a.range < b.range; });
  if (nearest == visible.end()) return;
  if (const auto measured = measureRange(sensor_, *nearest, random_)) first_ = First{time, nearest->feature, *measured};
}

std::optional<RunningFixReading> RunningFixSimulator::finish(double time, const VisibleFeature& feature,
                                                             const std::vector<SceneFeature>& features)
{
  const auto second = measureRange(sensor_, feature, random_);
  const auto motion = odometry_.displacement(first_->time, time);
  if (!second || !motion) return std::nullopt;
  RunningFixReading fix;
  fix.time = time;
  fix.first_time = first_->time;
  fix.sensor = sensor_.label;
  fix.T_robot_sensor = rounded(sensor_.T_robot_sensor);
  fix.sensor_height = sensor_.height;
  fix.horizontal_range = sensor_.horizontal_range;
  fix.model = declaredModel(sensor_);
  if (sensor_.identity == IdentityLevel::known) fix.id = features[feature.feature].id;
  fix.first_range = first_->measured.range;
  fix.first_std = first_->measured.std_range;
  fix.second_range = second->range;
  fix.second_std = second->std_range;
  fix.displacement = rounded(motion->mean);
  fix.displacement_covariance = motion->covariance.unaryExpr([](double v) { return std::round(v * 1e9) / 1e9; });
  if (sensor_.fix_bearing)
  {
    fix.second_bearing = measureBearing(sensor_, feature, random_);
    fix.second_bearing_std = rounded(sensor_.std_bearing);
  }
  return fix;
}
}  // namespace mrpt_ext
