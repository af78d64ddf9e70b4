#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
namespace
{
/// About the square of an angle whose tangent is across / along: its sine's, rising to 4 at half a turn.
double roughSquare(double across, double along)
{
  const double sine2 = across * across / std::max(across * across + along * along, 1e-300);
  return along > 0 ? sine2 : 4 - 3 * sine2;
}
}  // namespace

PoseResiduals::PoseResiduals(std::span<const PoseMeasurement> measurements)
{
  rows_.reserve(measurements.size() + 1);
  const auto add = [&](PoseMeasurement::Kind kind)
  {
    for (const PoseMeasurement& m : measurements)
    {
      if (m.kind != kind) continue;
      PoseResidual& row = rows_.emplace_back(PoseResidual{m.landmark, m.T_robot_sensor.position()});
      if (kind == PoseMeasurement::Kind::bearing) row.unit = direction(m.value + m.T_robot_sensor.phi);
      if (kind == PoseMeasurement::Kind::heading) row.unit = direction(m.value);
      if (kind == PoseMeasurement::Kind::range) row.range = m.value;
      row.weight = 1 / m.std;
    }
  };
  add(PoseMeasurement::Kind::bearing);
  ranges_begin_ = rows_.size();
  add(PoseMeasurement::Kind::range);
  headings_begin_ = rows_.size();
  add(PoseMeasurement::Kind::heading);
}

NormalEquations<3> PoseResiduals::model(const Pose2& pose) const
{
  double cost = 0, gx = 0, gy = 0, gp = 0, xx = 0, xy = 0, xp = 0, yy = 0, yp = 0, pp = 0;
  forEach(pose,
          [&](double e, const JacobianRow& j)
          {
            const double x = j[0], y = j[1], p = j[2];
            cost += e * e;
            gx += e * x, gy += e * y, gp += e * p;
            xx += x * x, xy += x * y, xp += x * p;
            yy += y * y, yp += y * p, pp += p * p;
          });
  NormalEquations<3> sum;
  sum.cost = cost;
  sum.gradient << gx, gy, gp;
  sum.hessian << xx, xy, xp, xy, yy, yp, xp, yp, pp;
  return sum;
}

double PoseResiduals::roughCost(const Vector2d& position, const Vector2d& heading) const
{
  double sum = 0;
  for (const PoseResidual& m : bearings())
  {
    const Vector2d d = m.landmark - position - turned(m.offset, heading), seen = turned(m.unit, heading);
    sum += square(m.weight) * roughSquare(cross(seen, d), seen.dot(d));
  }
  for (const PoseResidual& m : ranges())
  {
    const Vector2d d = m.landmark - position - turned(m.offset, heading);
    sum += square(m.weight * (d.norm() - m.range));
  }
  for (const PoseResidual& m : headings())
    sum += square(m.weight) * roughSquare(cross(m.unit, heading), m.unit.dot(heading));
  return sum;
}
}  // namespace mrpt_ext
