#pragma once

#include <algorithm>
#include <limits>

#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// How large the scene is that some measurements speak of; the guard of descents against poses that run off.
class SceneExtent
{
 public:
  explicit SceneExtent(const Vector2d& robot) : robot_(robot) {}

  void add(const PoseMeasurement& m)
  {
    if (m.kind == PoseMeasurement::Kind::heading) return;
    if (!first_) first_ = &m;
    nearest_ = std::min(nearest_, (m.landmark - robot_).norm());
    extent_ = std::max({extent_, (m.landmark - first_->landmark).norm(), m.T_robot_sensor.position().norm(),
                        m.kind == PoseMeasurement::Kind::range ? m.value : 0.0});
  }
  /// True if the robot is further from the landmarks than anything the measurements can speak of.
  [[nodiscard]] bool ranOff() const { return first_ && nearest_ > kFarAway * extent_; }

 private:
  static constexpr double kFarAway = 1e4;  // times the extent of the scene

  Vector2d robot_;
  const PoseMeasurement* first_ = nullptr;
  double nearest_ = std::numeric_limits<double>::infinity();
  double extent_ = 0;
};
}  // namespace mrpt_ext
