#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_mixture.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Null hypothesis of the pose test for detections with bearing and range (null_model.h is that for bearings alone):
/// what a robot without a map expects to measure. A static feature is seen again where it was seen before, as far as
/// odometry knows how the robot has moved since.
///
/// A wrong pose that fits two posts of a fence goes on to fit them, metre after metre. Compared with a uniform density
/// each time would be evidence; compared with this model only features that are seen for the first time are, or again
/// after odometry has lost them.
class PointNullModel
{
 public:
  /// `max_range` [m]: of a sensor that declares none.
  PointNullModel(const MotionModel& motion, double max_range) : motion_(motion), max_range_(max_range) {}

  void clear() { *this = PointNullModel(motion_, max_range_); }
  void move(const OdometryMotion& motion);
  /// The log density of the result is that of a detection [1/(m rad)], clutter included, given those before; the
  /// detection is remembered. It has both bearing and range.
  FeatureMixture::Outcome observe(const Reading& reading, const Detection& detection);

  /// Number of tracked features.
  [[nodiscard]] std::size_t size() const { return features_.size(); }

 private:
  /// A static feature in the axes of the robot, by a Kalman filter of its own.
  struct TrackedPoint
  {
    std::string sensor, category;
    Vector2d mean{0, 0};
    Matrix2d covariance;
  };

  MotionModel motion_;
  double max_range_;
  FeatureMixture mixture_;
  std::vector<TrackedPoint> features_;  // the last one seen last
};
}  // namespace mrpt_ext
