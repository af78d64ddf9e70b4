#include "mrpt_ext/observations/observation_conversions.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CObservationBearingRange.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/logged_flag.h"
#include "mrpt_ext/observations/timestamps.h"

namespace mrpt_ext
{
namespace
{
/// Time, label and sensor pose, the same for all classes.
template <typename Plain>
Plain withHeader(const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& sensor_pose)
{
  Plain plain;
  plain.time = isValid(observation.timestamp) ? secondsOf(observation.timestamp) : 0;
  plain.sensor = labelOf(observation);
  plain.T_robot_sensor = {sensor_pose.x(), sensor_pose.y(), sensor_pose.yaw()};
  plain.sensor_height = sensor_pose.z();
  return plain;
}

SensorModel declaredModel(double field_of_view, double max_range)
{
  SensorModel model;
  model.has_field_of_view = field_of_view > 0;
  if (model.has_field_of_view) model.field_of_view = std::min(field_of_view, kTwoPi);
  if (max_range > 0 && std::isfinite(max_range)) model.max_range = max_range;
  return model;
}
}  // namespace

Reading toReading(const CObservationLandmarkBearings& observation)
{
  auto reading = withHeader<Reading>(observation, observation.sensor_pose);
  reading.model = declaredModel(observation.field_of_view, observation.max_range);
  for (const auto& d : observation.detections)
    reading.detections.push_back(
        {.id = d.id, .category = d.category, .bearing = d.bearing, .range = {}, .std_bearing = d.std_bearing});
  return reading;
}

Reading toReading(const CObservationStereoRanges& observation)
{
  auto reading = withHeader<Reading>(observation, observation.sensor_pose);
  reading.model = declaredModel(observation.field_of_view, observation.max_range);
  reading.horizontal_range = observation.horizontal;
  for (const auto& d : observation.detections)
    reading.detections.push_back({.id = d.id,
                                  .category = d.category,
                                  .bearing = d.bearing,
                                  .range = d.range,
                                  .std_bearing = d.std_bearing,
                                  .std_range = observation.rangeStd(d),
                                  .facing = d.facing});
  return reading;
}

Reading toReading(const mrpt::obs::CObservationBearingRange& observation)
{
  auto reading = withHeader<Reading>(observation, observation.sensorLocationOnRobot);
  const bool limits_declared = observation.maxSensorDistance > 0;
  if (limits_declared) reading.model = declaredModel(observation.fieldOfView_yaw, observation.maxSensorDistance);
  for (const auto& measurement : observation.sensedData)
  {
    Detection d{.id = measurement.landmarkID, .category = {}, .bearing = measurement.yaw, .range = {}};
    if (measurement.range != 0) d.range = measurement.range;
    const bool own = isTrue(observation.validCovariances);
    d.std_range = own ? std::sqrt(measurement.covariance(0, 0)) : observation.sensor_std_range;
    d.std_bearing = own ? std::sqrt(measurement.covariance(1, 1)) : observation.sensor_std_yaw;
    reading.detections.push_back(d);
  }
  return reading;
}

std::vector<Reading> toReadings(const mrpt::obs::CObservationBeaconRanges& observation)
{
  std::vector<Reading> readings;
  std::map<std::array<double, 3>, std::size_t> reading_of_antenna;
  for (const auto& measurement : observation.sensedData)
  {
    const auto& antenna = measurement.sensorLocationOnRobot;
    const auto [entry, is_new] =
        reading_of_antenna.try_emplace({antenna.x(), antenna.y(), antenna.z()}, readings.size());
    if (is_new)
    {
      readings.push_back(withHeader<Reading>(observation, mrpt::poses::CPose3D(antenna)));
      readings.back().model = declaredModel(0, observation.maxSensorDistance);
    }
    readings[entry->second].detections.push_back({.id = measurement.beaconID,
                                                  .category = {},
                                                  .bearing = {},
                                                  .range = measurement.sensedDistance,
                                                  .std_bearing = 0,
                                                  .std_range = observation.stdError});
  }
  return readings;
}

RunningFixReading toRunningFix(const CObservationRunningFix& observation)
{
  auto fix = withHeader<RunningFixReading>(observation, observation.sensor_pose);
  fix.first_time = isValid(observation.first_timestamp) ? secondsOf(observation.first_timestamp) : fix.time;
  fix.horizontal_range = observation.horizontal;
  fix.id = observation.id;
  fix.first_range = observation.first_range;
  fix.first_std = observation.first_std;
  fix.second_range = observation.second_range;
  fix.second_std = observation.second_std;
  fix.displacement = {observation.displacement.x(), observation.displacement.y(), observation.displacement.phi()};
  fix.displacement_covariance = observation.displacement_covariance.asEigen();
  fix.second_bearing = observation.second_bearing;
  fix.second_bearing_std = observation.second_bearing_std;
  return fix;
}

RangeScan toRangeScan(const mrpt::obs::CObservation2DRangeScan& observation)
{
  auto scan = withHeader<RangeScan>(observation, observation.sensorPose);
  const std::size_t beams = observation.getScanSize();
  const bool has_intensities = observation.hasIntensity();
  const double sense = isTrue(observation.rightToLeft) ? 1 : -1;
  scan.first_bearing = -0.5 * sense * observation.aperture;
  scan.bearing_step = beams > 1 ? sense * observation.aperture / static_cast<double>(beams - 1) : 0.0;
  scan.std_range = observation.stdError;
  for (std::size_t beam = 0; beam < beams; ++beam)
  {
    const float range = observation.getScanRange(beam);
    const bool echo = observation.getScanRangeValidity(beam) && range > 0 && range < observation.maxRange;
    scan.ranges.push_back(echo ? range : 0);
    if (has_intensities) scan.intensities.push_back(static_cast<float>(observation.getScanIntensity(beam)));
  }
  return scan;
}

std::optional<LandmarkMeasurements> toMeasurements(const mrpt::obs::CObservation& observation)
{
  if (const auto* o = dynamic_cast<const CObservationLandmarkBearings*>(&observation))
    return LandmarkMeasurements{{toReading(*o)}, {}};
  if (const auto* o = dynamic_cast<const CObservationStereoRanges*>(&observation))
    return LandmarkMeasurements{{toReading(*o)}, {}};
  if (const auto* o = dynamic_cast<const mrpt::obs::CObservationBearingRange*>(&observation))
    return LandmarkMeasurements{{toReading(*o)}, {}};
  if (const auto* o = dynamic_cast<const mrpt::obs::CObservationBeaconRanges*>(&observation))
    return LandmarkMeasurements{toReadings(*o), {}};
  if (const auto* o = dynamic_cast<const CObservationRunningFix*>(&observation))
    return LandmarkMeasurements{{}, {toRunningFix(*o)}};
  return std::nullopt;
}

std::string shortClassName(const mrpt::rtti::CObject& object)
{
  const std::string name = object.GetRuntimeClass()->className;
  const auto colons = name.rfind("::");
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

std::string labelOf(const mrpt::obs::CObservation& observation)
{
  static const std::map<std::string, std::string> kLabels = {
      {"CObservationLandmarkBearings", "bearings"},  {"CObservationStereoRanges", "ranges"},
      {"CObservationRunningFix", "running_fix"},     {"CObservationBeaconRanges", "beacons"},
      {"CObservationBearingRange", "bearing_range"}, {"CObservationIMU", "compass"},
      {"CObservationOdometry", "odometry"},          {"CObservation2DRangeScan", "laser"}};
  if (!observation.sensorLabel.empty()) return observation.sensorLabel;
  const std::string name = shortClassName(observation);
  const auto label = kLabels.find(name);
  return label == kLabels.end() ? name : label->second;
}
}  // namespace mrpt_ext
