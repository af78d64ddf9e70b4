#include "mrpt_ext/solvers/bearing_pose_ml.h"

#include <algorithm>

#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/minimal_solvers.h"

namespace mrpt_ext
{
namespace
{
std::vector<KnownBearing> relativeTo(std::span<const KnownBearing> bearings, const Vector2d& origin)
{
  std::vector<KnownBearing> shifted(bearings.begin(), bearings.end());
  for (KnownBearing& b : shifted) b.landmark -= origin;
  return shifted;
}
}  // namespace

PoseMl solveBearingPoseMl(std::span<const KnownBearing> bearings)
{
  PoseMl failed;
  failed.status = checkBearings(bearings);
  if (failed.status == SolveStatus::bad_input || failed.status == SolveStatus::too_few) return failed;

  const Vector2d origin = landmarkMean(bearings);
  const std::vector<KnownBearing> local = relativeTo(bearings, origin);
  std::vector<PoseMeasurement> measurements;
  measurements.reserve(local.size());
  for (const KnownBearing& b : local)
    measurements.push_back({PoseMeasurement::Kind::bearing, b.landmark, b.bearing, b.std, {}});
  const PoseResiduals rows(measurements);
  std::vector<PoseGuess> seeds = solveMinimalSubsets(PoseResiduals(measurements), 1);
  if (seeds.empty())
  {
    const BearingPoseLinear linear = solveBearingPoseLinear(local);
    failed.status = linear.status;
    if (linear.status != SolveStatus::ok) return failed;
    seeds.push_back({{linear.pose.x, linear.pose.y, linear.mean_phi}});
  }
  PoseMl result = refinePose(measurements, seeds.front().pose);
  if (result.status != SolveStatus::ok) return result;

  const auto points_away = [](double r) { return std::abs(r) > 0.5 * kPi; };
  if (std::any_of(result.residuals.begin(), result.residuals.end(), points_away))
  {
    result.status = SolveStatus::behind;
    result.pose = {};
    return result;
  }
  result.pose.mean.x += origin.x();
  result.pose.mean.y += origin.y();
  return result;
}
}  // namespace mrpt_ext
