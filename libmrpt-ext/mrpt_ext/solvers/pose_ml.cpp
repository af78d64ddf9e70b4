#include "mrpt_ext/solvers/pose_ml.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
namespace
{
constexpr double kCauchyScale2 = 4;  // squared standard deviations
constexpr double kRunaway = 1e4;     // times the extent of the scene

/// Cost and model of all measurements under the loss.
NormalEquations<3> modelAt(const PoseResiduals& rows, Loss loss, const Pose2& pose)
{
  PoseResiduals::countRound(rows.size());
  if (loss == Loss::squared) return rows.model(pose);
  NormalEquations<3> sum;
  rows.forEach(pose,
               [&](double e, const JacobianRow& j)
               {
                 const double weight = 1 / (1 + e * e / kCauchyScale2);  // d cost / d (e^2)
                 sum.cost += kCauchyScale2 * std::log1p(e * e / kCauchyScale2);
                 sum.gradient += weight * e * j.transpose();
                 sum.hessian += weight * j.transpose() * j;
               });
  return sum;
}

/// True if the robot is further from the landmarks than anything the measurements can speak of.
bool ranOff(std::span<const PoseMeasurement> measurements, const Pose2& pose)
{
  const PoseMeasurement* first = nullptr;
  double nearest = std::numeric_limits<double>::infinity(), extent = 0;
  for (const PoseMeasurement& m : measurements)
  {
    if (m.kind == PoseMeasurement::Kind::heading) continue;
    if (!first) first = &m;
    nearest = std::min(nearest, (m.landmark - pose.position()).norm());
    extent = std::max({extent, (m.landmark - first->landmark).norm(), m.T_robot_sensor.position().norm(),
                       m.kind == PoseMeasurement::Kind::range ? m.value : 0.0});
  }
  return first && nearest > kRunaway * extent;
}
}  // namespace

void describeSolution(PoseMl& result, std::span<const PoseMeasurement> measurements, const Pose2& pose,
                      const NormalEquations<3>& there, const DescentReport& report)
{
  result.chi2 = there.cost;
  result.iterations = report.iterations;
  result.converged = report.converged;
  result.det_ratio = informationRatio(there.hessian);
  result.residuals.reserve(measurements.size());
  for (const PoseMeasurement& m : measurements) result.residuals.push_back(residual(m, pose));
  const std::optional<Matrix3d> covariance = covarianceFromInformation(there.hessian);
  result.status = SolveStatus::degenerate;
  if (!covariance || ranOff(measurements, pose)) return;
  result.status = SolveStatus::ok;
  result.pose = {{pose.x, pose.y, wrap(pose.phi)}, *covariance};
}

PoseMl refinePose(std::span<const PoseMeasurement> measurements, const Pose2& start, Loss loss)
{
  PoseMl result;
  if (!std::all_of(measurements.begin(), measurements.end(), isUsable) || !isFinite(start))
  {
    result.status = SolveStatus::bad_input;
    return result;
  }
  if (measurements.size() < 3) return result;

  const PoseResiduals rows(measurements);
  Pose2 pose = start;
  NormalEquations<3> now = modelAt(rows, loss, pose);
  result.start_chi2 = now.cost;
  const auto improved = [&](const Pose2& next, double bound) -> std::optional<NormalEquations<3>>
  {
    NormalEquations<3> there = modelAt(rows, loss, next);
    if (!(there.cost < bound)) return std::nullopt;
    return there;
  };
  const DescentReport report = descendFrom<3>(pose, now, improved, added);
  describeSolution(result, measurements, pose, now, report);
  return result;
}
}  // namespace mrpt_ext
