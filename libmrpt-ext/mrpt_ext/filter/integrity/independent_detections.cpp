#include "mrpt_ext/filter/integrity/independent_detections.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace mrpt_ext
{
namespace
{
constexpr double kMaxDistance = 0.3;            // [m] after which the same direction is independent again ...
constexpr double kMaxDistanceShare = 0.02;      // ... or this share of the map's diagonal, if less
constexpr double kSameDirection = degToRad(6);  // for the parallax over that distance, and odometry's error
constexpr double kGate = 3;                     // standard deviations

/// The reading with the detections that `keep` marks.
Reading only(const Reading& reading, const std::vector<bool>& keep)
{
  Reading result = reading;
  result.model.detection_probability.reset();
  result.detections.clear();
  for (std::size_t d = 0; d < keep.size(); ++d)
    if (keep[d]) result.detections.push_back(reading.detections[d]);
  return result;
}
}  // namespace

double decorrelationDistance(const LandmarkTable& map)
{
  if (map.size() < 2) return kMaxDistance;
  const auto [low, high] = map.boundingBox();
  return std::min(kMaxDistance, kMaxDistanceShare * (high - low).norm());
}

DetectionDecorrelator::DetectionDecorrelator(const MotionModel& motion, const LandmarkTable& map)
    : motion_(motion), min_distance_(decorrelationDistance(map))
{
}

void DetectionDecorrelator::move(const OdometryMotion& motion)
{
  odometry_.move(motion_, motion);
  std::erase_if(recent_, [&](const RecentDetection& other)
                { return squaredDistance(other.from, odometry_) > square(min_distance_); });
}

DetectionDecorrelator::RecentDetection DetectionDecorrelator::inOdometryAxes(const Reading& reading,
                                                                             const Detection& detection) const
{
  RecentDetection result{reading.sensor, detection, odometry_, 0};
  if (detection.bearing) result.direction = odometry_.pose.phi + reading.T_robot_sensor.phi + *detection.bearing;
  return result;
}

bool DetectionDecorrelator::isCorrelated(const RecentDetection& detection) const
{
  const auto same = [&](const RecentDetection& other)
  {
    const Detection &a = detection.detection, &b = other.detection;
    if (detection.sensor != other.sensor || a.id != b.id || a.category != b.category) return false;
    if (a.bearing.has_value() != b.bearing.has_value() || a.range.has_value() != b.range.has_value()) return false;
    if (a.id != kNoId) return true;
    const double drift = detection.from.heading_variance - other.from.heading_variance;
    const double bearing_gate =
        kSameDirection + kGate * std::sqrt(square(a.std_bearing) + square(b.std_bearing) + drift);
    if (a.bearing && std::abs(wrap(detection.direction - other.direction)) > bearing_gate) return false;
    const double range_gate = min_distance_ + kGate * std::hypot(a.std_range, b.std_range);
    return !a.range || std::abs(*a.range - *b.range) <= range_gate;
  };
  return std::any_of(recent_.begin(), recent_.end(), same);
}

std::vector<bool> DetectionDecorrelator::markIndependent(const Reading& reading)
{
  std::vector<bool> independent;
  std::vector<RecentDetection> added;
  for (const Detection& detection : reading.detections)
  {
    RecentDetection recent = inOdometryAxes(reading, detection);
    independent.push_back(!isCorrelated(recent));
    if (independent.back()) added.push_back(std::move(recent));
  }
  std::move(added.begin(), added.end(), std::back_inserter(recent_));
  return independent;
}

DetectionDecorrelator::Split DetectionDecorrelator::split(const Reading& reading)
{
  std::vector<bool> marks = markIndependent(reading);
  Reading independent = only(reading, marks);
  marks.flip();
  return {std::move(independent), only(reading, marks)};
}

Reading DetectionDecorrelator::independent(const Reading& reading) { return only(reading, markIndependent(reading)); }

Reading DetectionDecorrelator::withoutCorrelatedBearings(const Reading& reading)
{
  std::vector<bool> keep = markIndependent(reading);
  for (std::size_t d = 0; d < keep.size(); ++d)
    keep[d] = keep[d] || reading.detections[d].id != kNoId || reading.detections[d].range.has_value();
  const bool all = std::all_of(keep.begin(), keep.end(), [](bool kept) { return kept; });
  return all ? reading : only(reading, keep);
}
}  // namespace mrpt_ext
