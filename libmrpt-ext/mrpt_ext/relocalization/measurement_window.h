#pragma once

#include <deque>

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// Carries the readings of the last seconds along by odometry, so that a method sees one constellation measured at
/// several places. Sensor poses are expressed in the robot frame of the newest frame; the odometry noise on the way
/// grows their offset covariance and, by its heading error, the deviations of their bearings: each detection by itself
/// is then as uncertain as it is, which gates and scores need. But the readings of one moment share that error, and all
/// older ones share the error of the way that is common to them; treated as independent, a hundred of them would seem
/// to average it away. `Reading::odometry_covariance` keeps what is shared; solvers/window_pose.h uses it and is
/// neither over- nor under-confident. A random walk believes no odometry: readings stay where they were and grow
/// uncertain.
class MeasurementWindow
{
 public:
  /// `window` [s]; 0 keeps nothing.
  MeasurementWindow(double window, const MotionModel& motion) : window_(window), motion_(motion) {}

  /// Takes in the next frame.
  void add(const Frame& frame);
  /// The readings of the window, oldest first, seen from the newest frame.
  [[nodiscard]] std::vector<Reading> readings() const;
  /// True once the frames span the window: from then on the oldest readings are dropped.
  [[nodiscard]] bool full() const { return full_; }
  /// The newest frame with the older readings of the window added.
  [[nodiscard]] Frame joined() const;

 private:
  double window_;
  MotionModel motion_;
  Frame newest_;
  std::optional<double> first_time_;
  bool full_ = false;
  std::deque<Reading> older_;
};
}  // namespace mrpt_ext
