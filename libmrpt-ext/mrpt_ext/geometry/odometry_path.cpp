#include "mrpt_ext/geometry/odometry_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mrpt_ext
{
namespace
{
Pose2 poseAt(const Trajectory& odometry, double time)
{
  const double inside = std::clamp(time, odometry.front().time, odometry.back().time);
  return interpolate(odometry, inside, std::numeric_limits<double>::infinity())->pose;
}

/// Displacement and turn of a measured step, corrected; what is missed by distance and time is not added.
Pose2 scaledStep(const Pose2& step, const OdometryCorrection& correction)
{
  const double length = step.position().norm(), turned = std::abs(step.phi);
  double scale = correction.scale, turn_scale = correction.rotation_scale;
  if (!isArc({.increment = step, .length = length, .turned = turned}))
    turn_scale *= correction.pivot_scale;
  else
    // However much it falls behind, an arc does not become a turn in place.
    scale *= std::max(kInPlaceRadius * turned / length, 1 + correction.distance_per_turn * turned / length);
  const Vector2d moved = scale * rotation(correction.yaw) * step.position();
  return {moved.x(), moved.y(), turn_scale * step.phi};
}
}  // namespace

OdometryPath::OdometryPath(std::vector<OdometryRecord> records, const OdometryCorrection& correction)
    : correction_(correction)
{
  std::stable_sort(records.begin(), records.end(),
                   [](const OdometryRecord& a, const OdometryRecord& b) { return a.time < b.time; });
  for (const OdometryRecord& record : records) appendStep(record, false);
}

void OdometryPath::add(const OdometryRecord& record)
{
  const Pose2 &before = logged_.pose, &now = record.pose;
  const bool is_jump =
      !path_.empty() && jumps_.add(record.time, now.position() - before.position(), record.time - logged_.time,
                                   now.x == 0 && now.y == 0 && now.phi == 0);
  appendStep(record, is_jump);
}

void OdometryPath::appendStep(const OdometryRecord& record, bool is_jump)
{
  const OdometryRecord before = std::exchange(logged_, record);
  if (path_.empty())
  {
    path_.push_back({record.time + correction_.delay, record.pose, true});
    length_.push_back(0);
    turned_.push_back(0);
    return;
  }
  Pose2 step = is_jump ? Pose2{} : scaledStep(mrpt_ext::between(before.pose, record.pose), correction_);
  step.phi += correction_.turn_per_m * step.position().norm() + correction_.turn_per_s * (record.time - before.time);
  length_.push_back(length_.back() + step.position().norm());
  turned_.push_back(turned_.back() + std::abs(step.phi));
  path_.push_back({record.time + correction_.delay, compose(path_.back().pose, step), true});
}

void OdometryPath::forgetBefore(double time)
{
  constexpr std::ptrdiff_t kFew = 1000;  // are not worth moving the others
  const auto needed =
      std::partition_point(path_.begin(), path_.end(), [time](const TimedPose& entry) { return entry.time <= time; });
  const std::ptrdiff_t old = needed - path_.begin() - 1;  // one at or before `time` remains
  if (old < kFew) return;
  path_.erase(path_.begin(), path_.begin() + old);
  length_.erase(length_.begin(), length_.begin() + old);
  turned_.erase(turned_.begin(), turned_.begin() + old);
}

std::size_t OdometryPath::firstAfter(double time) const
{
  const auto after = std::upper_bound(path_.begin(), path_.end(), time,
                                      [](double wanted, const TimedPose& entry) { return wanted < entry.time; });
  return static_cast<std::size_t>(after - path_.begin());
}

OdometryPath::PathPoint OdometryPath::pointAt(double time) const
{
  if (path_.empty()) return {};
  const std::size_t after = firstAfter(time);
  if (after == 0) return {path_.front().pose, length_.front(), turned_.front()};
  const std::size_t i = after - 1;
  if (after == path_.size()) return {path_[i].pose, length_[i], turned_[i]};
  const double share = (time - path_[i].time) / (path_[i + 1].time - path_[i].time);
  const Pose2 step = mrpt_ext::between(path_[i].pose, path_[i + 1].pose);
  return {compose(path_[i].pose, {share * step.x, share * step.y, share * step.phi}),
          length_[i] + share * (length_[i + 1] - length_[i]), turned_[i] + share * (turned_[i + 1] - turned_[i])};
}

Pose2 OdometryPath::at(double time) const { return pointAt(time).pose; }

OdometryMotion OdometryPath::between(double from, double to) const
{
  const PathPoint a = pointAt(from), b = pointAt(to);
  OdometryMotion motion{mrpt_ext::between(a.pose, b.pose), b.length - a.length, b.turned - a.turned, to - from};
  motion.moments = momentsBetween(from, a, to, b);
  return motion;
}

std::optional<PathMoments> OdometryPath::momentsBetween(double from, const PathPoint& begin, double to,
                                                        const PathPoint& end) const
{
  const std::size_t first = firstAfter(from), last = firstAfter(to);
  if (!(first < last)) return std::nullopt;
  PathMoments moments;
  PathPoint before = begin;
  double time = from;
  const auto append_until = [&](double next, const PathPoint& point)
  {
    append(moments, mrpt_ext::between(begin.pose, before.pose),
           {mrpt_ext::between(before.pose, point.pose), point.length - before.length, point.turned - before.turned,
            next - time});
    before = point;
    time = next;
  };
  for (std::size_t i = first; i < last; ++i) append_until(path_[i].time, {path_[i].pose, length_[i], turned_[i]});
  append_until(to, end);
  return moments;
}

Pose2 motionBetween(const Trajectory& odometry, double from, double to)
{
  if (odometry.empty()) return {};
  return between(poseAt(odometry, from), poseAt(odometry, to));
}

PoseEstimate propagate(const PoseEstimate& estimate, const Trajectory& odometry, double time)
{
  PoseEstimate propagated = estimate;
  propagated.time = time;
  if (!estimate.heading_known) return propagated;
  propagated.pose = compound(estimate.pose, motionBetween(odometry, estimate.time, time));
  return propagated;
}
}  // namespace mrpt_ext
