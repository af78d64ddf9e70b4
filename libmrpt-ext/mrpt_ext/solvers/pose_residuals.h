#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/solvers/levenberg_marquardt.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// A measurement prepared for evaluation at many poses: bearings and headings are unit vectors.
struct PoseResidual
{
  Vector2d landmark{0, 0};  ///< world frame [m]
  Vector2d offset{0, 0};    ///< of the sensor, robot axes [m]
  Vector2d unit{1, 0};      ///< bearing: direction seen, robot axes; heading: direction of the robot, world axes
  double range = 0;         ///< [m], 0 for bearings and headings
  double weight = 1;        ///< 1 / std
};

/// Angle of the vector (along, across) [rad], as atan2: a short series, exact to rounding, where it is below 0.1.
[[nodiscard]] inline double smallAngle(double across, double along)
{
  if (!(std::abs(across) < 0.1 * along)) return std::atan2(across, along);
  const double t = across / along, t2 = t * t;
  const double tail = 1. / 9 - t2 * (1. / 11 - t2 * (1. / 13 - t2 * (1. / 15)));
  return t * (1 - t2 * (1. / 3 - t2 * (1. / 5 - t2 * (1. / 7 - t2 * tail))));
}

/// Residuals, Jacobians and cost of the measurements of one pose, sorted into bearings, ranges and headings.
class PoseResiduals
{
 public:
  explicit PoseResiduals(std::span<const PoseMeasurement> measurements);

  [[nodiscard]] std::span<const PoseResidual> bearings() const { return std::span(rows_).first(ranges_begin_); }
  [[nodiscard]] std::span<const PoseResidual> ranges() const
  {
    return std::span(rows_).subspan(ranges_begin_, headings_begin_ - ranges_begin_);
  }
  /// Bearings and ranges.
  [[nodiscard]] std::span<const PoseResidual> sightings() const { return std::span(rows_).first(headings_begin_); }
  [[nodiscard]] std::span<const PoseResidual> headings() const { return std::span(rows_).subspan(headings_begin_); }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  /// Adds an absolute heading.
  void addHeading(double heading, double std) { rows_.push_back({{0, 0}, {0, 0}, direction(heading), 0, 1 / std}); }

  /// Calls `row(e, jacobian)` for each measurement at `pose`: predicted minus measured and its derivative, both in
  /// standard deviations.
  template <class Row>
  void forEach(const Pose2& pose, const Row& row) const
  {
    const Vector2d position = pose.position(), heading = direction(pose.phi);
    for (const PoseResidual& m : bearings())
    {
      const Vector2d offset = turned(m.offset, heading), d = m.landmark - position - offset;
      const Vector2d seen = turned(m.unit, heading);
      const double r2 = d.squaredNorm(), w = r2 > 0 ? m.weight / r2 : 0;
      row(m.weight * smallAngle(cross(seen, d), seen.dot(d)),
          JacobianRow(w * d.y(), -w * d.x(), r2 > 0 ? -m.weight - w * d.dot(offset) : 0));
    }
    for (const PoseResidual& m : ranges())
    {
      const Vector2d offset = turned(m.offset, heading), d = m.landmark - position - offset;
      const double r = d.norm(), w = r > 0 ? m.weight / r : 0;
      row(m.weight * (r - m.range), JacobianRow(-w * d.x(), -w * d.y(), w * cross(d, offset)));
    }
    for (const PoseResidual& m : headings())
      row(m.weight * smallAngle(cross(m.unit, heading), m.unit.dot(heading)), JacobianRow(0, 0, m.weight));
  }

  /// Sum of squares at `pose`, with gradient and J^T J.
  [[nodiscard]] NormalEquations<3> model(const Pose2& pose) const;

  /// Approximate sum of squares without trigonometry: the sine replaces the angle, and grows beyond a right angle.
  /// Ranks guesses before they are refined.
  [[nodiscard]] double roughCost(const Vector2d& position, const Vector2d& heading) const;

  /// Counts the work of linearising so many measurements at one pose: of a round of a descent (work_counter.h).
  static void countRound(std::size_t measurements) { WorkCounter::add(80 + 35 * measurements); }

  /// `v` rotated by the angle of the unit vector `by`.
  [[nodiscard]] static Vector2d turned(const Vector2d& v, const Vector2d& by)
  {
    return {by.x() * v.x() - by.y() * v.y(), by.y() * v.x() + by.x() * v.y()};
  }

 private:
  std::vector<PoseResidual> rows_;  ///< bearings, ranges, headings
  std::size_t ranges_begin_ = 0, headings_begin_ = 0;
};
}  // namespace mrpt_ext
