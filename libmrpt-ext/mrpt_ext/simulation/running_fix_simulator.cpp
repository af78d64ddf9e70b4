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

std::optional<RunningFixReading> RunningFixSimulator::look(double time, const Pose2& robot,
                                                           const std::vector<SceneFeature>& features)
{
  std::vector<VisibleFeature> sightings = sightingsFrom(sensor_, robot, features);
  std::erase_if(sightings, [&](const VisibleFeature&) { return !random_.chance(sensor_.detection_probability); });
  const bool far_enough = first_ && path_.lengthAt(time) - path_.lengthAt(first_->time) >= sensor_.fix_distance;
  if (!first_ || sightings.empty())
  {
    begin(time, sightings);
    return std::nullopt;
  }
  const auto again = std::find_if(sightings.begin(), sightings.end(),
                                  [&](const VisibleFeature& sighting) { return sighting.feature == first_->feature; });
  if (again == sightings.end()) begin(time, sightings);
  if (again == sightings.end() || !far_enough) return std::nullopt;
  const auto fix = finish(time, *again, features);
  first_.reset();
  return fix;
}

void RunningFixSimulator::begin(double time, const std::vector<VisibleFeature>& sightings)
{
  first_.reset();
  const auto nearest =
      std::min_element(sightings.begin(), sightings.end(),
                       [](const VisibleFeature& a, const VisibleFeature& b) { return a.range < b.range; });
  if (nearest == sightings.end()) return;
  if (const auto measured = measureRange(sensor_, *nearest, random_)) first_ = First{time, nearest->feature, *measured};
}

std::optional<RunningFixReading> RunningFixSimulator::finish(double time, const VisibleFeature& sighting,
                                                             const std::vector<SceneFeature>& features)
{
  const auto second = measureRange(sensor_, sighting, random_);
  const auto way = odometry_.displacement(first_->time, time);
  if (!second || !way) return std::nullopt;
  RunningFixReading fix;
  fix.time = time;
  fix.first_time = first_->time;
  fix.sensor = sensor_.label;
  fix.T_robot_sensor = rounded(sensor_.T_robot_sensor);
  fix.sensor_height = sensor_.height;
  fix.horizontal_range = sensor_.horizontal_range;
  fix.model = declaredModel(sensor_);
  if (sensor_.identity == IdentityLevel::known) fix.id = features[sighting.feature].id;
  fix.first_range = first_->measured.range;
  fix.first_std = first_->measured.std_range;
  fix.second_range = second->range;
  fix.second_std = second->std_range;
  fix.displacement = rounded(way->mean);
  fix.displacement_covariance = way->covariance.unaryExpr([](double v) { return std::round(v * 1e9) / 1e9; });
  if (sensor_.fix_bearing)
  {
    fix.second_bearing = measureBearing(sensor_, sighting, random_);
    fix.second_bearing_std = rounded(sensor_.std_bearing);
  }
  return fix;
}
}  // namespace mrpt_ext
