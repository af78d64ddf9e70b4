#pragma once

#include <algorithm>
#include <cstddef>

namespace mrpt_ext
{
/// Finds the steps of odometry that no robot drives: where its driver was started anew, the pose jumps.
///
/// Wheels grip with about the weight of the robot, so twice that acceleration within one step, to ten times the speed
/// of all steps before, is no motion; a second such step in a row is, of a fast robot. Nor is a step to exactly the
/// origin, faster than all before or over a pause: dead reckoning that runs does not come back there.
class OdometryJumps
{
 public:
  /// The next step, of `distance` [m] within `duration` [s] up to `time` [s]. Returns whether it is a jump.
  bool add(double time, double distance, double duration, bool to_origin)
  {
    steps_ += 1;
    elapsed_ += duration;
    const double spacing = elapsed_ / steps_, within = std::max(duration, spacing);  // stamps may lie too close
    const double speed = within > 0 ? distance / within : 0;
    const bool no_motion = !after_jump_ && steps_ > kLeastSteps && speed > kFaster * std::max(fastest_, kSlow) &&
                           speed > kMostAcceleration * within;
    const bool starts_anew = to_origin && distance > 0 && (speed > 2 * fastest_ || duration > kPause * spacing);
    after_jump_ = no_motion || starts_anew;
    if (!after_jump_)
    {
      fastest_ = std::max(fastest_, speed);
      return false;
    }
    ++count_;
    if (distance > longest_)
    {
      longest_ = distance;
      time_ = time;
    }
    return true;
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double longest() const { return longest_; }     ///< [m]
  [[nodiscard]] double timeOfLongest() const { return time_; }  ///< [s]

 private:
  static constexpr double kLeastSteps = 20;
  static constexpr double kFaster = 10;            // times the fastest step before
  static constexpr double kSlow = 1;               // [m/s] that any robot may drive
  static constexpr double kMostAcceleration = 20;  // [m/s^2]
  static constexpr double kPause = 5;              // times the mean duration of a step

  double steps_ = 0, elapsed_ = 0;  // number, [s]
  double fastest_ = 0;              // [m/s]
  bool after_jump_ = false;
  std::size_t count_ = 0;
  double longest_ = 0, time_ = 0;
};
}  // namespace mrpt_ext
