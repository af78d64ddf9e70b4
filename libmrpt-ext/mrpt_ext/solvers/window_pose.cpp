#include "mrpt_ext/solvers/window_pose.h"

#include <algorithm>

#include "mrpt_ext/solvers/window_noise.h"

namespace mrpt_ext
{
namespace
{
/// The quadratic model of the joint cost at a pose. Steps are in world axes, so the noise is turned into them.
NormalEquations<3> modelAt(std::span<const WindowMeasurements> readings, const Pose2& pose)
{
  NormalEquations<3> information;
  const Matrix3d to_world = composeJacobianSecond(pose);
  for (std::size_t k = 0; k < readings.size(); ++k)
  {
    for (const PoseMeasurement& m : readings[k].measurements)
      addReading(information, residual(m, pose), jacobian(m, pose), m.std);
    Matrix3d noise = readings[k].odometry_covariance;
    if (k + 1 < readings.size()) noise -= readings[k + 1].odometry_covariance;
    diffuse<3>(information, to_world * noise * to_world.transpose());
  }
  return information;
}

bool isUsableReading(const WindowMeasurements& reading)
{
  return reading.odometry_covariance.allFinite() && reading.odometry_covariance.diagonal().minCoeff() >= 0 &&
         std::all_of(reading.measurements.begin(), reading.measurements.end(), isUsable);
}
}  // namespace

PoseMl refineWindowPose(std::span<const WindowMeasurements> oldest_first, const Pose2& start)
{
  PoseMl result;
  result.status = SolveStatus::bad_input;
  if (!isFinite(start) || !std::all_of(oldest_first.begin(), oldest_first.end(), isUsableReading)) return result;
  std::vector<PoseMeasurement> all;
  for (const WindowMeasurements& reading : oldest_first)
    all.insert(all.end(), reading.measurements.begin(), reading.measurements.end());
  result.status = SolveStatus::too_few;
  if (all.size() < 3) return result;

  Pose2 pose = start;
  const auto model = [&](const Pose2& p) { return modelAt(oldest_first, p); };
  const auto cost = [&](const Pose2& p) { return modelAt(oldest_first, p).cost; };
  result.start_chi2 = cost(start);
  const DescentReport report = descend<3>(pose, model, cost, added, {.relative_step = 1e-10});
  describeSolution(result, all, pose, model(pose), report);
  return result;
}
}  // namespace mrpt_ext
