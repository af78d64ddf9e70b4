#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Finds the steps of odometry that no robot drives: where its driver was started anew, or a record is damaged.
///
/// Wheels grip with about the weight of the robot, so twice that acceleration within one step, to ten times the speed
/// of all steps before, is no motion. A second such step is one if it continues the first, as that of a fast robot
/// does; one that takes the first back is none either. Nor is a step to exactly the origin, twice as fast as all before
/// or over a pause: dead reckoning that runs does not come back there.
class OdometryJumps
{
 public:
  /// The next step, in the axes of odometry [m], within `duration` [s] up to `time` [s]. Returns whether it is a jump.
  bool add(double time, const Vector2d& step, double duration, bool to_origin)
  {
    const bool is_pause = steps_ > 0 && duration > kPause * spacing();
    if (!is_pause)
    {
      steps_ += 1;
      elapsed_ += duration;
    }
    const double within = std::max(duration, spacing());  // stamps may lie too close together
    const double speed = within > 0 ? step.norm() / within : 0;
    const bool continues = last_jump_ && isAbout(step, *last_jump_),
               returns = last_jump_ && isAbout(-step, *last_jump_);
    const bool slips = speed > kMostAcceleration * within;
    const bool is_fast = steps_ > kLeastSteps && slips && speed > kFaster * std::max(fastest_, kSlow);
    const bool starts_anew = to_origin && step.norm() > kNear && (speed > 2 * fastest_ || is_pause);
    if (returns || starts_anew || (is_fast && !continues))
    {
      record(time, step);
      return true;
    }
    last_jump_.reset();
    if (continues || !slips) fastest_ = std::max(fastest_, speed);
    return false;
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
  static constexpr double kNear = 0.1;             // [m] that wheels may jitter
  static constexpr double kAlike = 0.5;            // difference of two steps over the length of one

  static bool isAbout(const Vector2d& step, const Vector2d& other)
  {
    return (step - other).norm() < kAlike * other.norm();
  }
  /// [s] mean duration of a step.
  [[nodiscard]] double spacing() const { return steps_ > 0 ? elapsed_ / steps_ : 0; }
  void record(double time, const Vector2d& step)
  {
    last_jump_ = step;
    ++count_;
    if (!(step.norm() > longest_)) return;
    longest_ = step.norm();
    time_ = time;
  }

  double steps_ = 0, elapsed_ = 0;     // number and [s], without pauses
  double fastest_ = 0;                 // [m/s]
  std::optional<Vector2d> last_jump_;  // of the step before, if it was one
  std::size_t count_ = 0;
  double longest_ = 0, time_ = 0;
};
}  // namespace mrpt_ext
