#include "mrpt_ext/filter/integrity/independent_detections.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mrpt_ext
{
namespace
{
constexpr double kSameDirection = degToRad(6);  // for parallax over a piece of way and odometry's error
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

DetectionDecorrelator::DetectionDecorrelator(const DecorrelationOptions& spacing, const MotionModel& motion,
                                             const LandmarkTable& map)
    : motion_(motion), look_way_(spacing.longest)
{
  if (map.size() < 2) return;
  const auto [low, high] = map.boundingBox();
  look_way_ = std::min(look_way_, spacing.share * (high - low).norm());
}

void DetectionDecorrelator::move(const OdometryMotion& motion)
{
  odometry_.move(motion_, motion);
  std::erase_if(looks_, [&](const Look& look) { return (look.from - odometry_.pose.position()).norm() > look_way_; });
}

DetectionDecorrelator::Look DetectionDecorrelator::lookOf(const Reading& reading, const Detection& detection) const
{
  Look look{reading.sensor, detection, odometry_.pose.position(), 0, odometry_.heading_variance};
  if (detection.bearing) look.direction = odometry_.pose.phi + reading.T_robot_sensor.phi + *detection.bearing;
  return look;
}

bool DetectionDecorrelator::isRepeat(const Look& look) const
{
  const auto same = [&](const Look& other)
  {
    const Detection &a = look.detection, &b = other.detection;
    if (look.sensor != other.sensor || a.id != b.id || a.category != b.category) return false;
    if (a.bearing.has_value() != b.bearing.has_value() || a.range.has_value() != b.range.has_value()) return false;
    const double turned = look.heading_variance - other.heading_variance;
    const double bearing_gate =
        kSameDirection + kGate * std::sqrt(square(a.std_bearing) + square(b.std_bearing) + turned);
    if (a.bearing && std::abs(wrap(look.direction - other.direction)) > bearing_gate) return false;
    const double range_gate = look_way_ + kGate * std::hypot(a.std_range, b.std_range);
    return a.id != kNoId || !a.range || std::abs(*a.range - *b.range) <= range_gate;
  };
  return std::any_of(looks_.begin(), looks_.end(), same);
}

std::vector<bool> DetectionDecorrelator::freshOnes(const Reading& reading)
{
  std::vector<bool> fresh;
  std::vector<Look> added;
  for (const Detection& detection : reading.detections)
  {
    Look look = lookOf(reading, detection);
    fresh.push_back(!isRepeat(look));
    if (fresh.back()) added.push_back(std::move(look));
  }
  std::move(added.begin(), added.end(), std::back_inserter(looks_));
  return fresh;
}

Reading DetectionDecorrelator::take(const Reading& reading) { return only(reading, freshOnes(reading)); }

Reading DetectionDecorrelator::withoutCorrelatedBearings(const Reading& reading)
{
  std::vector<bool> keep = freshOnes(reading);
  for (std::size_t d = 0; d < keep.size(); ++d)
    keep[d] = keep[d] || reading.detections[d].id != kNoId || reading.detections[d].range.has_value();
  const bool all = std::all_of(keep.begin(), keep.end(), [](bool kept) { return kept; });
  return all ? reading : only(reading, keep);
}
}  // namespace mrpt_ext
