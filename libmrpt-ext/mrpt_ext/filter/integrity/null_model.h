#pragma once

#include <array>
#include <string>
#include <vector>

#include "mrpt_ext/filter/motion/dead_reckoning.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// What somebody without a map expects to see: what stands still is seen where it was seen before, moved by parallax.
///
/// A place on the map that has once taken up a bearing without a name goes on to agree with the same thing, right or
/// wrong: the next bearing of it is no surprise to anybody. So the evidence for a place (pose_verification_test.h) is
/// measured against this model, not against bearings spread evenly. Each thing is a direction in odometry's axes and a
/// distribution over its range; a bearing comes from one of the things in view, or from a new one, with the odds at
/// which new ones have come so far.
class NullModel
{
 public:
  /// `max_range` [m]: things farther away are not told apart from those at that range.
  NullModel(const MotionModel& motion, double max_range);

  void clear() { *this = NullModel(motion_, max_range_); }
  void move(const OdometryMotion& motion);
  /// Logarithm of the density [1/rad] that a bearing of a reading has, false ones included, given those before; it is
  /// remembered. The detection has a bearing and no range.
  double take(const Reading& reading, const Detection& bearing);

  [[nodiscard]] std::size_t size() const { return things_.size(); }

 private:
  static constexpr std::size_t kRanges = 40;
  struct Thing
  {
    std::string sensor, category;
    std::array<Vector2d, kRanges> where;  ///< in odometry's axes, nearest first
    std::array<double, kRanges> share;    ///< sum 1
    double std_bearing = 0;               ///< of the bearing that laid down its direction [rad]
    double heading_variance = 0;          ///< of odometry when it was seen last [rad^2]
  };
  /// A thing as the sensor would see it now.
  struct Expected
  {
    double in_view = 0;  ///< probability
    double density = 0;  ///< of the bearing [1/rad]
    std::array<double, kRanges> share;
  };

  [[nodiscard]] Expected expect(const Thing& thing, const Pose2& sensor, const SensorModel& model,
                                const Detection& bearing) const;
  void place(Thing& thing, const Pose2& sensor, const Detection& bearing, const std::array<double, kRanges>& ranges);

  MotionModel motion_;
  double max_range_;
  DeadReckoning odometry_;  // since the start
  double taken_ = 0, new_ones_ = 0;
  std::vector<Thing> things_;
};
}  // namespace mrpt_ext
