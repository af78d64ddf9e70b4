// The half of observation_conversions.h that makes observations from plain values.
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <algorithm>
#include <cmath>

#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/timestamps.h"

namespace mrpt_ext
{
namespace
{
template <typename Plain>
void setHeader(mrpt::obs::CObservation& observation, const Plain& plain)
{
  observation.timestamp = timestampOf(plain.time);
  observation.sensorLabel = plain.sensor;
  const Pose2& mount = plain.T_robot_sensor;
  observation.setSensorPose(mrpt::poses::CPose3D(mount.x, mount.y, plain.sensor_height, mount.phi, 0, 0));
}

template <typename Observation>
void setSensorModel(Observation& observation, const SensorModel& model)
{
  observation.field_of_view = model.has_field_of_view ? model.field_of_view : 0;
  observation.max_range = model.max_range.value_or(0);
}
}  // namespace

CObservationLandmarkBearings::Ptr toLandmarkBearings(const Reading& reading)
{
  auto observation = CObservationLandmarkBearings::Create();
  setHeader(*observation, reading);
  setSensorModel(*observation, reading.model);
  for (const Detection& d : reading.detections)
    if (d.bearing)
      observation->detections.push_back(
          {.id = d.id, .category = d.category, .bearing = *d.bearing, .std_bearing = d.std_bearing});
  return observation;
}

CObservationStereoRanges::Ptr toStereoRanges(const Reading& reading)
{
  auto observation = CObservationStereoRanges::Create();
  setHeader(*observation, reading);
  setSensorModel(*observation, reading.model);
  observation->horizontal = reading.horizontal_range;
  for (const Detection& d : reading.detections)
    observation->detections.push_back({.id = d.id,
                                       .category = d.category,
                                       .range = d.range,
                                       .std_range = d.std_range,
                                       .std_disparity = 0,
                                       .bearing = d.bearing,
                                       .std_bearing = d.std_bearing,
                                       .facing = d.facing});
  return observation;
}

CObservationRunningFix::Ptr toObservation(const RunningFixReading& fix)
{
  auto observation = CObservationRunningFix::Create();
  setHeader(*observation, fix);
  observation->horizontal = fix.horizontal_range;
  observation->id = fix.id;
  observation->first_timestamp = timestampOf(fix.first_time);
  observation->first_range = fix.first_range;
  observation->first_std = fix.first_std;
  observation->second_range = fix.second_range;
  observation->second_std = fix.second_std;
  observation->displacement = {fix.displacement.x, fix.displacement.y, fix.displacement.phi};
  observation->displacement_covariance = mrpt::math::CMatrixDouble33(fix.displacement_covariance);
  observation->second_bearing = fix.second_bearing;
  observation->second_bearing_std = fix.second_bearing_std;
  return observation;
}

mrpt::obs::CObservation2DRangeScan::Ptr toObservation(const RangeScan& scan)
{
  auto observation = mrpt::obs::CObservation2DRangeScan::Create();
  const std::size_t beams = scan.ranges.size();
  const double span = beams > 1 ? scan.bearing_step * static_cast<double>(beams - 1) : 0.0;
  RangeScan symmetric = scan;
  symmetric.T_robot_sensor.phi = wrap(scan.T_robot_sensor.phi + scan.first_bearing + 0.5 * span);
  setHeader(*observation, symmetric);
  observation->aperture = static_cast<float>(std::abs(span));
  observation->rightToLeft = span >= 0;
  observation->stdError = static_cast<float>(scan.std_range);
  observation->resizeScan(beams);
  observation->setScanHasIntensity(!scan.intensities.empty());
  for (std::size_t beam = 0; beam < beams; ++beam)
  {
    observation->setScanRange(beam, scan.ranges[beam]);
    observation->setScanRangeValidity(beam, scan.ranges[beam] > 0);
    observation->maxRange = std::max(observation->maxRange, 2 * scan.ranges[beam]);
    if (!scan.intensities.empty())
      observation->setScanIntensity(beam,
                                    static_cast<int>(std::lround(std::clamp(scan.intensities[beam], 0.0F, 1e9F))));
  }
  return observation;
}

bool hasRange(const Reading& reading)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& d) { return d.range.has_value(); });
}

bool hasFacing(const Reading& reading)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& d) { return d.facing.has_value(); });
}
}  // namespace mrpt_ext
