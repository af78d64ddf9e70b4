#include "mrpt_ext/geometry/trajectory.h"

#include <algorithm>

namespace mrpt_ext
{
std::optional<TimedPose> interpolate(const Trajectory& trajectory, double time, double max_gap)
{
  const auto after = std::lower_bound(trajectory.begin(), trajectory.end(), time,
                                      [](const TimedPose& entry, double wanted) { return entry.time < wanted; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == trajectory.begin()) return std::nullopt;
  const TimedPose& a = *(after - 1);
  const TimedPose& b = *after;
  if (b.time - a.time > max_gap) return std::nullopt;
  const double share = (time - a.time) / (b.time - a.time);
  const Pose2 pose{a.pose.x + share * (b.pose.x - a.pose.x), a.pose.y + share * (b.pose.y - a.pose.y),
                   wrap(a.pose.phi + share * wrap(b.pose.phi - a.pose.phi))};
  return TimedPose{time, pose, a.heading_known && b.heading_known};
}
}  // namespace mrpt_ext
