#pragma once

#include <cstddef>
#include <optional>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Whether landmarks support the pose, or only odometry.
///
/// In a spell without landmarks the pose is odometry's, and the stated covariance is as good as the stated noise. A
/// detection then that fits no landmark is clutter, or the first sign that odometry has erred more than it is said to:
/// which of both only a landmark that fits can tell. While most of the variance was there before the spell this does
/// not matter; from then on such a detection leaves the pose unsupported until a landmark fits.
class PoseSupport
{
 public:
  void move(double seconds) { since_landmark_ += seconds; }
  /// Inliers among the detections of a frame, and the covariance of the pose after it.
  void observe(double inliers, std::size_t detections, const Matrix3d& covariance)
  {
    if (detections == 0) return;
    if (inliers > kFits || !at_landmark_)
    {
      at_landmark_ = covariance;
      since_landmark_ = 0;
      supported_ = true;
    }
    else
      supported_ = supported_ && !isMostlyOdometry(*at_landmark_, covariance);
  }
  [[nodiscard]] bool supported() const { return supported_; }
  /// Seconds since a landmark fitted, where odometry has most of the pose's covariance, which is now this.
  [[nodiscard]] std::optional<double> spell(const Matrix3d& covariance) const
  {
    return at_landmark_ && isMostlyOdometry(*at_landmark_, covariance) ? std::optional(since_landmark_) : std::nullopt;
  }

 private:
  static constexpr double kFits = 0.5;   // inliers: one detection rather shows a landmark than not
  static constexpr double kDoubled = 2;  // the standard deviation: three quarters of the variance are odometry's

  [[nodiscard]] static bool isMostlyOdometry(const Matrix3d& before, const Matrix3d& now)
  {
    const auto position = [](const Matrix3d& C) { return C(0, 0) + C(1, 1); };
    return position(now) > square(kDoubled) * position(before) || now(2, 2) > square(kDoubled) * before(2, 2);
  }

  std::optional<Matrix3d> at_landmark_;  // covariance when a landmark fitted last, or at the start
  double since_landmark_ = 0;            // [s]
  bool supported_ = true;
};
}  // namespace mrpt_ext
