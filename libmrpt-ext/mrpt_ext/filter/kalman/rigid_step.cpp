#include "mrpt_ext/filter/kalman/rigid_step.h"

#include <cmath>

#include "mrpt_ext/geometry/arc_motion.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSmallAngle = 1e-4;  // [rad] below which the series is exact to rounding

/// By the angle: (a - sin(a)) / a^2 and (1 - cos(a)) / a^2.
struct ArcDerivatives
{
  double along, across;
};

ArcDerivatives arcDerivatives(double a)
{
  if (std::abs(a) < kSmallAngle) return {a / 6, 0.5 - a * a / 24};
  return {(a - std::sin(a)) / (a * a), (1 - std::cos(a)) / (a * a)};
}

/// From the tangent of the arc to the displacement.
Matrix2d arcMatrix(double angle)
{
  const Pose2 end = arcMotion(1, angle, 1);
  return (Matrix2d() << end.x, -end.y, end.y, end.x).finished();
}

/// From motions of the plane that are told about a point to the same ones told about where `step` leads it.
KalmanMatrix toldAbout(const KalmanVector& step)
{
  const Vector2d displacement = arcMatrix(step[2]) * step.head<2>();
  KalmanMatrix T = KalmanMatrix::Identity(step.size(), step.size());
  T(0, 2) = -displacement.y();
  T(1, 2) = displacement.x();
  return T;
}
}  // namespace

KalmanVector movedRigidly(const KalmanVector& mean, const KalmanVector& step)
{
  KalmanVector result = mean + step;
  result.head<2>() = mean.head<2>() + arcMatrix(step[2]) * step.head<2>();
  result[2] = wrap(result[2]);
  return result;
}

KalmanVector rigidStep(const KalmanVector& from, const KalmanVector& to)
{
  KalmanVector step = to - from;
  step[2] = wrap(step[2]);
  const Matrix2d arc = arcMatrix(step[2]);
  step.head<2>() = (arc.transpose() * (to - from).head<2>() / arc.determinant()).eval();
  return step;
}

KalmanMatrix rigidStepJacobian(const KalmanVector& step)
{
  KalmanMatrix J = KalmanMatrix::Identity(step.size(), step.size());
  const ArcDerivatives by_angle = arcDerivatives(step[2]);
  J.topLeftCorner<2, 2>() = arcMatrix(step[2]);
  J(0, 2) = by_angle.along * step[0] + by_angle.across * step[1];
  J(1, 2) = by_angle.along * step[1] - by_angle.across * step[0];
  return toldAbout(step) * J;
}

KalmanMatrix transported(const KalmanMatrix& covariance, const KalmanVector& step)
{
  const KalmanMatrix to_end = toldAbout(step), moved = to_end * covariance * to_end.transpose();
  return 0.5 * (moved + moved.transpose());
}
}  // namespace mrpt_ext
