#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/diagnosis/bias_free_filter.h"
#include "mrpt_ext/diagnosis/time_blocks.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// A delay that explains the detections significantly better than none.
struct DelayFinding
{
  double delay = 0;   ///< [s] how much older the detections are than odometry at their stamps
  double effect = 0;  ///< root mean square error of the pose that it causes, in standard deviations of the pose
};

/// A measurement whose landmark is known, to be predicted from several poses.
struct MatchedMeasurement
{
  bool is_range = false;
  double value = 0, std = 0;  ///< [rad] or [m]
  Vector2d landmark{0, 0};    ///< [m] map frame
  double height = 0;          ///< [m] of the landmark above the sensor; 0 for horizontal ranges
  Pose2 T_robot_sensor;
};
/// Its linearization at `robot`; the sensitivity to systematic errors is empty.
[[nodiscard]] ScalarMeasurement linearize(const MatchedMeasurement& measurement, const Pose2& robot);

/// Kalman filters side by side, each for another delay between detections and odometry: the motion between two frames
/// is taken that much earlier. The delay with the largest likelihood of the innovations is the answer. A regression on
/// the velocity would not do: velocity from odometry has the noise of the innovations in it.
class DelayHypotheses
{
 public:
  /// `odometry` must outlive it.
  DelayHypotheses(const OdometryPath& odometry, const MotionModel& motion);

  void start(const GaussianPose& pose, double time);
  void predict(double time);
  /// `counts` is false while the start is not forgotten.
  void update(const MatchedMeasurement& measurement, bool counts);
  void endFrame(bool counts);

  /// Nothing when no delay explains the detections significantly better.
  [[nodiscard]] std::optional<DelayFinding> finding() const;

 private:
  [[nodiscard]] double refined(std::size_t best, const Eigen::VectorXd& log_likelihood) const;

  const OdometryPath& odometry_;
  std::vector<double> delays_;           // [s] ascending
  Eigen::Index none_;                    // number of the delay 0
  std::vector<BiasFreeFilter> filters_;  // one per delay
  TimeBlocks<Eigen::VectorXd> blocks_;   // log likelihoods
  double time_ = 0;                      // [s] of the frame before
  double effect_ = 0, frames_ = 0;       // sum over frames of the squared effect of one second
};
}  // namespace mrpt_ext
