#include "mrpt_ext/simulation/robot_path.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
RobotPath::RobotPath(const Pose2& start, const std::vector<TwistSegment>& segments)
{
  Leg leg;
  leg.pose = start;
  for (const TwistSegment& segment : segments)
  {
    leg.motion = segment;
    legs_.push_back(leg);
    leg.begin += segment.duration;
    leg.pose = compose(leg.pose, arcMotion(segment.speed, segment.turn_rate, segment.duration));
    leg.length += std::abs(segment.speed) * segment.duration;
    leg.turned += std::abs(segment.turn_rate) * segment.duration;
  }
  leg.motion = {};
  legs_.push_back(leg);
}

std::pair<const RobotPath::Leg*, double> RobotPath::legAt(double time) const
{
  const auto next = std::upper_bound(legs_.begin(), legs_.end(), time,
                                     [](double wanted, const Leg& leg) { return wanted < leg.begin; });
  const Leg& leg = next == legs_.begin() ? legs_.front() : *std::prev(next);
  return {&leg, std::max(0.0, time - leg.begin)};
}

Pose2 RobotPath::poseAt(double time) const
{
  const auto [leg, elapsed] = legAt(time);
  return compose(leg->pose, arcMotion(leg->motion.speed, leg->motion.turn_rate, elapsed));
}

double RobotPath::lengthAt(double time) const
{
  const auto [leg, elapsed] = legAt(time);
  return leg->length + std::abs(leg->motion.speed) * elapsed;
}

double RobotPath::turnedAt(double time) const
{
  const auto [leg, elapsed] = legAt(time);
  return leg->turned + std::abs(leg->motion.turn_rate) * elapsed;
}
}  // namespace mrpt_ext
