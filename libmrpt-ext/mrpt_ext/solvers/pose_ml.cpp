#include "mrpt_ext/solvers/pose_ml.h"

#include <algorithm>

#include "mrpt_ext/solvers/divergence_guard.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
namespace
{
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

/// Cost and model of all measurements under the loss.
NormalEquations<3> modelAt(const PoseResiduals& rows, const PoseMlOptions& options, const Pose2& pose)
{
  if (options.loss == Loss::squared) return rows.model(pose);
  NormalEquations<3> sum;
  rows.forEach(pose,
               [&](double e, const JacobianRow& j)
               {
                 const LossValue loss = evaluate(options, e * e);
                 sum.cost += loss.cost;
                 sum.gradient += loss.weight * e * j.transpose();
                 sum.hessian += loss.weight * j.transpose() * j;
               });
  return sum;
}

bool diverged(std::span<const PoseMeasurement> measurements, const Pose2& pose)
{
  DivergenceGuard guard(pose.position());
  for (const PoseMeasurement& m : measurements) guard.add(m);
  return guard.diverged();
}

void describe(PoseMl& result, std::span<const PoseMeasurement> measurements, const PoseMlOptions& options,
              const Pose2& pose)
{
  result.residuals.reserve(measurements.size());
  result.weights.reserve(measurements.size());
  for (const PoseMeasurement& m : measurements)
  {
    const double r = residual(m, pose);
    result.residuals.push_back(r);
    result.weights.push_back(evaluate(options, square(r / m.std)).weight);
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

  const PoseResiduals rows(measurements);
  Pose2 pose = start;
  NormalEquations<3> now = modelAt(rows, options, pose);
  result.start_chi2 = now.cost;
  const auto improved = [&](const Pose2& next, double bound) -> std::optional<NormalEquations<3>>
  {
    NormalEquations<3> there = modelAt(rows, options, next);
    if (!(there.cost < bound)) return std::nullopt;
    return there;
  };
  const DescentReport report = descendFrom<3>(pose, now, improved, added, {options.max_iterations});
  result.chi2 = now.cost;
  result.iterations = report.iterations;
  result.converged = report.converged;
  result.det_ratio = informationRatio(now.hessian);
  describe(result, measurements, options, pose);

  const std::optional<Matrix3d> covariance = covarianceFromInformation(now.hessian);
  if (!covariance || diverged(measurements, pose))
  {
    result.status = SolveStatus::degenerate;
    return result;
  }
  result.status = SolveStatus::ok;
  result.pose = {{pose.x, pose.y, wrap(pose.phi)}, *covariance};
  return result;
}
}  // namespace mrpt_ext
