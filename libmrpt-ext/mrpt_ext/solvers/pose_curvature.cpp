#include "mrpt_ext/solvers/pose_curvature.h"

#include <Eigen/Cholesky>
#include <array>

namespace mrpt_ext
{
namespace
{
/// A column of the root of P as the landmark, relative to the sensor, sees it: along and across the line of sight.
struct Shift
{
  double along = 0, across = 0, turn = 0;
};

/// Second derivative of a bearing in the directions of two shifts; `lever` is the sensor's offset on the robot, along
/// and across the line of sight of length r.
double bendOfBearing(const Shift& k, const Shift& l, const Vector2d& lever, double r)
{
  return -(k.along * l.across + k.across * l.along) / (r * r) + lever.y() / r * k.turn * l.turn;
}

double bendOfRange(const Shift& k, const Shift& l, const Vector2d& lever, double r)
{
  return k.across * l.across / r + lever.x() * k.turn * l.turn;
}
/// A root of P, P = L L^T, whose first column is what an error of one standard deviation in the worst known direction
/// of the position brings along.
Matrix3d rootFromWeakest(const Matrix3d& P)
{
  const double turn = 0.5 * std::atan2(2 * P(0, 1), P(0, 0) - P(1, 1));
  Matrix3d axes = Matrix3d::Identity();
  axes.topLeftCorner<2, 2>() = rotation(turn);
  const Matrix3d root = (axes.transpose() * P * axes).llt().matrixL();
  return axes * root;
}
}  // namespace

PoseCurvature poseCurvature(const PoseResiduals& rows, const Pose2& pose, const Matrix3d& P)
{
  const Matrix3d L = rootFromWeakest(P);
  const Vector2d heading = direction(pose.phi);
  std::array<Vector3d, 6> bends;  // sum_i w_i (J_i L)^T (L_k^T H_i L_l) for (k, l) = 00 01 02 11 12 22
  bends.fill(Vector3d::Zero());
  const auto add = [&](const PoseResidual& m, auto&& derivative, auto&& bend)
  {
    const Vector2d offset = PoseResiduals::turned(m.offset, heading), d = m.landmark - pose.position() - offset;
    const double r = d.norm();
    if (!(r > 0)) return;
    const Vector2d along = d / r, across = perpendicular(along), arm = perpendicular(offset);
    const Vector2d lever(along.dot(offset), across.dot(offset));
    std::array<Shift, 3> shifts;
    Vector3d whitened;
    for (int k = 0; k < 3; ++k)
    {
      const Vector2d moved = -L.block<2, 1>(0, k) - L(2, k) * arm;
      shifts[k] = {along.dot(moved), across.dot(moved), L(2, k)};
      whitened[k] = derivative(shifts[k], r);
    }
    std::size_t index = 0;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = k; l < 3; ++l)
        bends[index++] += square(m.weight) * bend(shifts[k], shifts[l], lever, r) * whitened;
  };
  for (const PoseResidual& m : rows.bearings())
    add(
        m, [](const Shift& s, double r) { return s.across / r - s.turn; }, bendOfBearing);
  for (const PoseResidual& m : rows.ranges())
    add(
        m, [](const Shift& s, double) { return s.along; }, bendOfRange);

  // E[(z^T A z)(z^T B z)] = tr A tr B + 2 tr AB for standard normal z.
  const Vector3d trace = bends[0] + bends[3] + bends[5];
  Matrix3d moment = trace * trace.transpose();
  for (std::size_t index = 0; index < 6; ++index)
  {
    const bool diagonal = index == 0 || index == 3 || index == 5;
    moment += (diagonal ? 2 : 4) * bends[index] * bends[index].transpose();
  }
  moment /= 4;
  return {std::sqrt(moment.trace()), L * moment * L.transpose(), L.col(0), -0.5 * L * bends[0]};
}
}  // namespace mrpt_ext
