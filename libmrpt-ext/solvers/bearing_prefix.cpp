#include "mrpt_ext/solvers/bearing_prefix.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
namespace
{
constexpr int kIterations = 6;
constexpr double kLargestShift = 0.5;  // of the distance to the nearest matched landmark

struct Normal
{
  Matrix3d hessian = Matrix3d::Zero();
  Vector3d gradient = Vector3d::Zero();
  double sse = 0;
};

/// Of the sum of squared residuals, equal weights.
Normal normalEquations(const std::vector<MatchedBearing>& matched, const Pose2& pose)
{
  Normal result;
  for (const MatchedBearing& m : matched)
  {
    const double e = wrap(predictBearing(pose, m.landmark) - m.bearing);
    const JacobianRow row = bearingJacobian(pose, m.landmark);
    result.hessian += row.transpose() * row;
    result.gradient += e * row.transpose();
    result.sse += e * e;
  }
  return result;
}

/// Relative to the size of its entries; a triple is never refined, its pose is exact.
bool wellConditioned(const Matrix3d& hessian)
{
  const double size = square(0.5 * (hessian(0, 0) + hessian(1, 1))) * hessian(2, 2);
  return hessian.determinant() > 1e-13 * size;
}
}  // namespace

void updatePrefix(BearingPrefix& prefix, const std::vector<MatchedBearing>& matched, const Pose2& start, double error)
{
  prefix.pose = start;
  prefix.reliable = false;
  Normal normal = normalEquations(matched, start);
  if (!wellConditioned(normal.hessian)) return;
  Matrix3d inverse = normal.hessian.inverse();
  for (int k = 0; matched.size() > 3 && k < kIterations; ++k)
  {
    const Vector3d step = -inverse * normal.gradient;
    const Pose2 next{prefix.pose.x + step.x(), prefix.pose.y + step.y(), prefix.pose.phi + step.z()};
    const double gain = -normal.gradient.dot(step);
    const Normal at_next = normalEquations(matched, next);
    if (at_next.sse > normal.sse || !wellConditioned(at_next.hessian)) break;
    prefix.pose = next;
    normal = at_next;
    inverse = normal.hessian.inverse();
    if (gain < 1e-4 * square(error)) break;
  }
  prefix.sse = normal.sse;

  prefix.sensitivity.resize(3, static_cast<Eigen::Index>(matched.size()));
  prefix.nearest = std::numeric_limits<double>::infinity();
  Vector2d reach = Vector2d::Zero();
  for (std::size_t i = 0; i < matched.size(); ++i)
  {
    const auto column = static_cast<Eigen::Index>(i);
    prefix.sensitivity.col(column) = inverse * bearingJacobian(prefix.pose, matched[i].landmark).transpose();
    reach += prefix.sensitivity.col(column).head<2>().cwiseAbs();
    prefix.nearest = std::min(prefix.nearest, (matched[i].landmark - prefix.pose.position()).norm());
  }
  prefix.shift = error * reach.norm();
  prefix.reliable = prefix.shift <= kLargestShift * prefix.nearest;
}

double gateAt(const BearingPrefix& prefix, const Vector2d& landmark, double distance, double error,
              InterpretationGate gate)
{
  if (prefix.shift > 0.7 * distance) return kPi;
  const JacobianRow row = bearingJacobian(prefix.pose, landmark);
  if (gate == InterpretationGate::covariance)
  {
    double squares = 0;
    for (Eigen::Index i = 0; i < prefix.sensitivity.cols(); ++i) squares += square(row * prefix.sensitivity.col(i));
    return error * std::sqrt(1 + squares);
  }
  double sum = 0;
  for (Eigen::Index i = 0; i < prefix.sensitivity.cols(); ++i) sum += std::abs(row * prefix.sensitivity.col(i));
  const double stretch = distance / (distance - prefix.shift) * prefix.nearest / (prefix.nearest - prefix.shift);
  return error * (1 + sum * stretch);
}
}  // namespace mrpt_ext
