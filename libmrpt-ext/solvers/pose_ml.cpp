#include "mrpt_ext/solvers/pose_ml.h"

#include <algorithm>

#include "mrpt_ext/solvers/levenberg_marquardt.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
namespace
{
constexpr double kFarAway = 1e4;  // times the extent of the scene

struct LossValue
{
  double cost = 0;
  double weight = 1;  // d cost / d (e^2)
};

LossValue evaluate(const PoseMlOptions& options, double e2)
{
  const double k = options.loss_scale;
  switch (options.loss)
  {
    case Loss::squared:
      return {e2, 1};
    case Loss::huber:
    {
      if (e2 <= k * k) return {e2, 1};
      const double e = std::sqrt(e2);
      return {2 * k * e - k * k, k / e};
    }
    case Loss::cauchy:
      return {k * k * std::log1p(e2 / (k * k)), 1 / (1 + e2 / (k * k))};
  }
  return {e2, 1};
}

struct Problem
{
  std::span<const PoseMeasurement> measurements;
  const PoseMlOptions& options;

  [[nodiscard]] double cost(const Pose2& pose) const
  {
    double sum = 0;
    for (const PoseMeasurement& m : measurements) sum += evaluate(options, square(residual(m, pose) / m.std)).cost;
    return sum;
  }

  [[nodiscard]] NormalEquations<3> model(const Pose2& pose) const
  {
    NormalEquations<3> result;
    for (const PoseMeasurement& m : measurements)
    {
      const double e = residual(m, pose) / m.std;
      const JacobianRow row = jacobian(m, pose) / m.std;
      const LossValue loss = evaluate(options, e * e);
      result.cost += loss.cost;
      result.gradient += loss.weight * e * row.transpose();
      result.hessian += loss.weight * row.transpose() * row;
    }
    return result;
  }
};

Pose2 moved(const Pose2& pose, const Vector3d& step)
{
  return {pose.x + step.x(), pose.y + step.y(), wrap(pose.phi + step.z())};
}

/// True if the pose is further from the landmarks than anything the measurements can speak of.
bool ranOff(std::span<const PoseMeasurement> measurements, const Pose2& pose)
{
  double nearest = std::numeric_limits<double>::infinity(), extent = 0;
  const PoseMeasurement* first = nullptr;
  for (const PoseMeasurement& m : measurements)
  {
    if (m.kind == PoseMeasurement::Kind::heading) continue;
    if (!first) first = &m;
    nearest = std::min(nearest, (m.landmark - pose.position()).norm());
    extent = std::max({extent, (m.landmark - first->landmark).norm(), m.T_robot_sensor.position().norm(),
                       m.kind == PoseMeasurement::Kind::range ? m.value : 0.0});
  }
  return first && nearest > kFarAway * extent;
}

void describe(PoseMl& result, const Problem& problem, const Pose2& pose)
{
  for (const PoseMeasurement& m : problem.measurements)
  {
    const double r = residual(m, pose);
    result.residuals.push_back(r);
    result.weights.push_back(evaluate(problem.options, square(r / m.std)).weight);
  }
}
}  // namespace

PoseMl refinePose(std::span<const PoseMeasurement> measurements, const Pose2& start, const PoseMlOptions& options)
{
  PoseMl result;
  const bool usable = std::all_of(measurements.begin(), measurements.end(), isUsable);
  if (!usable || !isFinite(start) || !(options.loss_scale > 0))
  {
    result.status = SolveStatus::bad_input;
    return result;
  }
  if (measurements.size() < 3) return result;

  const Problem problem{measurements, options};
  Pose2 pose = start;
  result.start_chi2 = problem.cost(start);
  const DescentReport report = descend<3>(
      pose, [&](const Pose2& p) { return problem.model(p); }, [&](const Pose2& p) { return problem.cost(p); }, moved,
      {options.max_iterations});
  const NormalEquations<3> at_solution = problem.model(pose);
  result.chi2 = at_solution.cost;
  result.iterations = report.iterations;
  result.converged = report.converged;
  result.det_ratio = informationRatio(at_solution.hessian);
  describe(result, problem, pose);

  const std::optional<Matrix3d> covariance = covarianceFromInformation(at_solution.hessian);
  if (!covariance || ranOff(measurements, pose))
  {
    result.status = SolveStatus::degenerate;
    return result;
  }
  result.status = SolveStatus::ok;
  result.pose = {{pose.x, pose.y, wrap(pose.phi)}, *covariance};
  return result;
}
}  // namespace mrpt_ext
