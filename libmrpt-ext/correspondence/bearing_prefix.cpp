#include "mrpt_ext/correspondence/bearing_prefix.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/levenberg_marquardt.h"

namespace mrpt_ext
{
namespace
{
constexpr int kIterations = 20;
constexpr double kLargestShift = 0.6;  // of the distance to the nearest matched landmark

// The rows of measurement_jacobian.h without a sensor offset: no trigonometry in the innermost loop of the search.
JacobianRow rowTowards(const Vector2d& d)
{
  const double inverse = 1 / d.squaredNorm();
  return {d.y() * inverse, -d.x() * inverse, -1};
}

double misfitAt(const MatchedBearing& m, const Pose2& pose, const Vector2d& to_landmark)
{
  return wrap(std::atan2(to_landmark.y(), to_landmark.x()) - pose.phi - m.bearing);
}

double sumOfSquares(const std::vector<MatchedBearing>& matched, const Pose2& pose)
{
  double sum = 0;
  for (const MatchedBearing& m : matched) sum += square(misfitAt(m, pose, m.landmark - pose.position()));
  return sum;
}

NormalEquations<3> normalEquations(const std::vector<MatchedBearing>& matched, const Pose2& pose)
{
  NormalEquations<3> result;
  for (const MatchedBearing& m : matched)
  {
    const Vector2d d = m.landmark - pose.position();
    const double e = misfitAt(m, pose, d);
    const JacobianRow row = rowTowards(d);
    result.hessian += row.transpose() * row;
    result.gradient += e * row.transpose();
    result.cost += e * e;
  }
  return result;
}

/// A triple needs no refinement, its pose is exact.
void refine(Pose2& pose, const std::vector<MatchedBearing>& matched, double error)
{
  if (matched.size() <= 3) return;
  DescentOptions options;
  options.max_iterations = kIterations;
  options.relative_step = 1e-3;
  options.good_enough = 1e-4 * square(error);
  descend<3>(
      pose, [&](const Pose2& p) { return normalEquations(matched, p); },
      [&](const Pose2& p) { return sumOfSquares(matched, p); },
      [](const Pose2& p, const Vector3d& step) {
        return Pose2{p.x + step.x(), p.y + step.y(), wrap(p.phi + step.z())};
      },
      options);
}

/// Relative to the size of its entries.
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
  refine(prefix.pose, matched, error);
  const NormalEquations<3> normal = normalEquations(matched, prefix.pose);
  prefix.sse = normal.cost;
  if (!wellConditioned(normal.hessian)) return;
  const Matrix3d inverse = normal.hessian.inverse();
  prefix.sensitivity.resize(3, static_cast<Eigen::Index>(matched.size()));
  prefix.nearest = std::numeric_limits<double>::infinity();
  Vector2d reach = Vector2d::Zero();
  for (std::size_t i = 0; i < matched.size(); ++i)
  {
    const auto column = static_cast<Eigen::Index>(i);
    const Vector2d d = matched[i].landmark - prefix.pose.position();
    prefix.sensitivity.col(column) = inverse * rowTowards(d).transpose();
    reach += prefix.sensitivity.col(column).head<2>().cwiseAbs();
    prefix.nearest = std::min(prefix.nearest, d.norm());
  }
  prefix.shift = error * reach.norm();
  prefix.reliable = prefix.shift <= kLargestShift * prefix.nearest;
}

double gateAt(const BearingPrefix& prefix, const Vector2d& to_landmark, double error, InterpretationGate gate)
{
  const double distance = to_landmark.norm();
  if (prefix.shift > 0.7 * distance) return kPi;
  const JacobianRow row = rowTowards(to_landmark);
  double sum = 0;
  if (gate == InterpretationGate::covariance)
  {
    for (Eigen::Index i = 0; i < prefix.sensitivity.cols(); ++i) sum += square(row * prefix.sensitivity.col(i));
    return error * std::sqrt(1 + sum);
  }
  for (Eigen::Index i = 0; i < prefix.sensitivity.cols(); ++i) sum += std::abs(row * prefix.sensitivity.col(i));
  const double stretch = distance / (distance - prefix.shift) * prefix.nearest / (prefix.nearest - prefix.shift);
  return error * (1 + sum * stretch);
}
}  // namespace mrpt_ext
