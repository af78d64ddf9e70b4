#pragma once

#include "mrpt_ext/filter/integrity/feature_null_model.h"

namespace mrpt_ext
{
/// Test of "odometry led to where the pose is" against "odometry has erred more than it is said to", after a spell in
/// which it alone moved the pose.
///
/// The first anonymous detection after such a spell is associated with whatever landmark is nearest, and the pose moves
/// there; that it fits then proves nothing. Before the spell the pose was right; that odometry slipped has a prior that
/// grows with time. Independent detections count with their likelihood under the pose before it is moved by them,
/// against a null hypothesis of features that remembers nothing from before the spell: if odometry erred, that is lost
/// as well. A precise pose is believed again with the first landmark it predicts, an imprecise one with the second or
/// third.
class SlipTest
{
 public:
  static constexpr double kSlipRate = 1e-3;  ///< [1/s] prior of slips that the noise of odometry does not cover

  /// `max_range` [m]: of a sensor that declares none.
  SlipTest(const MotionModel& motion, double max_range) : features_(motion, max_range) {}

  /// Nothing speaks for a slip.
  void clear() { log_odds_ = kMaxLogOdds; }
  /// Odometry alone has moved the pose for so many seconds.
  void suspect(double seconds);
  void move(const OdometryMotion& motion);
  /// The only, independent detection of a reading, and its log density under the pose. `max_range`: as above.
  void count(const Reading& part, double log_density, double max_range);
  /// The same for a detection that does not count for the pose: the null hypothesis remembers it.
  void skip(const Reading& part, double max_range);
  /// Detections that are correlated with those before.
  void track(const Reading& correlated);

  [[nodiscard]] bool refuted() const { return log_odds_ >= kRefutedLogOdds; }

 private:
  static constexpr double kMaxLogOdds = 14;     // nothing is counted there
  static constexpr double kRefutedLogOdds = 6;  // one slip in exp(6) = 400 gets that far

  [[nodiscard]] bool isSuspected() const { return log_odds_ < kMaxLogOdds; }

  FeatureNullModel features_;  // seen since the spell
  double log_odds_ = kMaxLogOdds;
};
}  // namespace mrpt_ext
