#pragma once

#include "mrpt_ext/filter/integrity/feature_null_model.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/measurement.h"

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
/// third. Once refuted, a slip is suspected again after the next spell only.
class SlipTest
{
 public:
  static constexpr double kSlipRate = 1e-3;  ///< [1/s] prior of slips that the noise of odometry does not cover

  /// `max_range` [m]: of a sensor that declares none.
  SlipTest(const MotionModel& motion, double max_range) : features_(motion, max_range) {}

  /// Nothing speaks for a slip.
  void clear() { log_odds_ = kRefutedLogOdds; }
  /// Odometry alone has moved the pose for so many seconds.
  void suspect(double seconds);
  void move(const OdometryMotion& motion);
  /// The only, independent detection of a reading, and its log density under the pose.
  void count(const Reading& part, double log_density);
  /// The same for a detection that does not count for the pose: the null hypothesis remembers it.
  void skip(const Reading& part);
  /// Detections that are correlated with those before.
  void track(const Reading& correlated);

  [[nodiscard]] bool refuted() const { return log_odds_ >= kRefutedLogOdds; }

 private:
  static constexpr double kRefutedLogOdds = 6;  // of the poses that are believed one in exp(6) = 400 has slipped

  FeatureNullModel features_;          // seen since the spell
  double log_odds_ = kRefutedLogOdds;  // not below 0: clutter is no proof of a slip, and costs no later landmark
};
}  // namespace mrpt_ext
