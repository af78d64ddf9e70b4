#pragma once

#include <algorithm>
#include <limits>

#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// Detects that an iteration diverged: compares the distance of the robot from the landmarks with the extent of the
/// scene, which is that of the landmarks, the sensor positions and the ranges.
class DivergenceGuard
{
 public:
  explicit DivergenceGuard(const Vector2d& robot) : robot_(robot) {}

  void add(const PoseMeasurement& m)
  {
    if (m.kind == PoseMeasurement::Kind::heading) return;
    if (!first_) first_ = &m;
    nearest_ = std::min(nearest_, (m.landmark - robot_).norm());
    extent_ = std::max({extent_, (m.landmark - first_->landmark).norm(), m.T_robot_sensor.position().norm(),
                        m.kind == PoseMeasurement::Kind::range ? m.value : 0.0});
  }
  /// True if the nearest landmark is 10 000 times farther away than the scene is large.
  [[nodiscard]] bool diverged() const { return first_ && nearest_ > kFarAway * extent_; }

 private:
  static constexpr double kFarAway = 1e4;

  Vector2d robot_;
  const PoseMeasurement* first_ = nullptr;
  double nearest_ = std::numeric_limits<double>::infinity();
  double extent_ = 0;
};
}  // namespace mrpt_ext
