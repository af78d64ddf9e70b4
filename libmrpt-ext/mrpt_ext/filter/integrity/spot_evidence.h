#pragma once

#include <algorithm>
#include <set>
#include <string>

#include "mrpt_ext/filter/motion/dead_reckoning.h"

namespace mrpt_ext
{
/// How much the detections of one spot may count, together.
///
/// The first reading of a sensor at a new spot is an unbiased sample. Later readings from there are not: their true
/// detections repeat those before and are left out as correlated, so that what remains is mostly clutter. An hour of it
/// would refute the right pose, or by many chances prove a wrong one. So all later readings at a spot together count
/// within limits, and take back at most what the first ones gave. Of an identified landmark the first detection is
/// unbiased, and the only one that counts.
class SpotEvidence
{
 public:
  static constexpr double kMost = 4.5, kLeast = -2.5;  ///< log-likelihood ratio of all later readings together

  /// `distance` [m] between two spots.
  SpotEvidence(const MotionModel& motion, double distance) : motion_(motion), distance_(distance) {}

  /// True when the robot has reached a new spot.
  bool move(const OdometryMotion& motion)
  {
    odometry_.move(motion_, motion);
    if (!(squaredDistance(spot_, odometry_) > square(distance_))) return false;
    spot_ = odometry_;
    sensors_.clear();
    first_ = repeated_ = 0;
    return true;
  }
  /// True for the first reading of the sensor at this spot.
  bool isFirstOf(const std::string& sensor) { return sensors_.insert(sensor).second; }
  /// What counts of a reading's log-likelihood ratio.
  [[nodiscard]] double counted(double log_ratio, bool first)
  {
    if (first)
    {
      first_ += log_ratio;
      return log_ratio;
    }
    const double before = repeated_;
    repeated_ = std::clamp(repeated_ + log_ratio, std::max(kLeast, std::min(0.0, -first_)), kMost);
    return repeated_ - before;
  }

 private:
  MotionModel motion_;
  double distance_;
  DeadReckoning odometry_, spot_;    // since the start: now, and where the spot was reached
  std::set<std::string> sensors_;    // that have looked from here
  double first_ = 0, repeated_ = 0;  // log-likelihood ratios of the first readings and of all later ones
};
}  // namespace mrpt_ext
