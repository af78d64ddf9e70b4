#pragma once

#include <deque>

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Sliding window: the readings of the last seconds, propagated by odometry to the newest frame, so that a method sees
/// them as measured by many sensors at once. Sensor poses are given in the robot frame of the newest frame. The
/// odometry noise inflates the covariance of their positions and, by its heading error, the standard deviations of
/// their bearings: the marginal uncertainty of each detection is right, as gates and likelihoods need it. However, the
/// readings of one frame share that error, and older ones share the error of their common trajectory; treated as
/// independent, a hundred of them would seem to average it away. `Reading::odometry_covariance` keeps the shared part,
/// and solvers/window_pose.h uses it for a consistent covariance. For a random walk, odometry is ignored: readings stay
/// at their pose and become uncertain with time.
class MeasurementWindow
{
 public:
  /// `window` [s]; 0: the newest frame alone.
  MeasurementWindow(double window, const MotionModel& motion) : window_(window), motion_(motion) {}

  /// Propagates the readings to the next frame and adds its own.
  void add(const Frame& frame);
  /// The readings of the window, oldest first.
  [[nodiscard]] std::vector<Reading> readings() const;
  /// True once the frames span the window; from then on the oldest readings are dropped.
  [[nodiscard]] bool full() const { return full_; }
  /// The newest frame with all readings of the window.
  [[nodiscard]] Frame frame() const;

 private:
  double window_;
  MotionModel motion_;
  Frame newest_;
  std::optional<double> first_time_;
  bool full_ = false;
  std::deque<Reading> older_;
};
}  // namespace mrpt_ext
