#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "mrpt_ext/filter/motion/dead_reckoning.h"

namespace mrpt_ext
{
/// How much the detections of one spot may count, together.
///
/// The first reading of a sensor at a new spot is an unbiased sample. Later readings from there are not: their true
/// detections repeat those before and are left out as correlated, so that what remains is mostly clutter. An hour of it
/// would refute the right pose, or by many chances prove a wrong one. So all later readings at a spot together count
/// within limits, and take back at most what the first ones gave.
///
/// Of an identified landmark only the first detection from a spot counts. The longer the robot stands, the more likely
/// that one is false: whatever can be seen from there has been seen. The null hypothesis knows that as well
/// (againstRepetition()).
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
  bool isFirstOf(const std::string& sensor) { return !std::exchange(sensors_[sensor].has_looked, true); }
  /// Share of the sensor's next detections that nothing was known of, by Laplace's rule of succession; 1 at first.
  [[nodiscard]] double shareOfNew(const std::string& sensor) const
  {
    const auto found = sensors_.find(sensor);
    return found == sensors_.end() ? 1 : (found->second.fresh + 1) / (found->second.all + 1);
  }
  /// A reading of the sensor with this many detections, and independent ones among them.
  void count(const std::string& sensor, std::size_t all, std::size_t independent)
  {
    sensors_[sensor].all += static_cast<double>(all);
    sensors_[sensor].fresh += static_cast<double>(independent);
  }
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
  /// What a sensor has seen from here.
  struct Looks
  {
    bool has_looked = false;
    double all = 0, fresh = 0;  // detections
  };

  MotionModel motion_;
  double distance_;
  DeadReckoning odometry_, spot_;  // since the start: now, and where the spot was reached
  std::map<std::string, Looks> sensors_;
  double first_ = 0, repeated_ = 0;  // log-likelihood ratios of the first readings and of all later ones
};

/// Log-likelihood ratio of a detection of an identified landmark that was not seen from this spot before, if only
/// `share_of_new` of the detections are: others that show no landmark of the spot are clutter under either hypothesis.
/// `log_ratio`: the ratio for a share of 1, e + (1 - e) N V with the clutter probability e.
[[nodiscard]] inline double againstRepetition(double log_ratio, double share_of_new, double clutter)
{
  constexpr double kFinite = 100;
  const double fits = std::max(0.0, std::exp(std::min(log_ratio, kFinite)) - clutter);
  return std::log((share_of_new * fits + clutter) / (share_of_new * (1 - clutter) + clutter));
}
}  // namespace mrpt_ext
