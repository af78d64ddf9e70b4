#include "mrpt_ext/solvers/bearing_pose_ml.h"

#include <algorithm>

#include "mrpt_ext/solvers/bearing_pose_gls.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"

namespace mrpt_ext
{
namespace
{
double misfit(std::span<const KnownBearing> bearings, const Pose2& pose)
{
  const std::vector<double> residuals = bearingResiduals(bearings, pose);
  double sum = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) sum += square(residuals[i] / bearings[i].std);
  return sum;
}

/// Closed-form poses with landmark `reference` first.
std::vector<Pose2> closedForms(std::vector<KnownBearing> bearings, std::size_t reference)
{
  std::swap(bearings[0], bearings[reference]);
  std::vector<Pose2> poses;
  const BearingPoseLinear linear = solveBearingPoseLinear(bearings);
  if (linear.status == SolveStatus::ok) poses.push_back({linear.pose.x, linear.pose.y, linear.mean_phi});
  const BearingPoseGls gls = solveBearingPoseGls(bearings);
  if (gls.status == SolveStatus::ok) poses.push_back(gls.pose);
  return poses;
}

/// The closed form that explains the bearings best; nothing when none has a pose.
std::optional<Pose2> bestSeed(const std::vector<KnownBearing>& bearings)
{
  std::vector<Pose2> seeds = closedForms(bearings, 0);
  for (std::size_t reference = 1; seeds.empty() && bearings.size() > 3 && reference < bearings.size(); ++reference)
    seeds = closedForms(bearings, reference);
  if (seeds.empty()) return std::nullopt;
  return *std::min_element(seeds.begin(), seeds.end(),
                           [&](const Pose2& a, const Pose2& b) { return misfit(bearings, a) < misfit(bearings, b); });
}

std::vector<KnownBearing> relativeTo(std::span<const KnownBearing> bearings, const Vector2d& origin)
{
  std::vector<KnownBearing> shifted(bearings.begin(), bearings.end());
  for (KnownBearing& b : shifted) b.landmark -= origin;
  return shifted;
}
}  // namespace

PoseMl solveBearingPoseMl(std::span<const KnownBearing> bearings, const PoseMlOptions& options)
{
  PoseMl failed;
  failed.status = checkBearings(bearings);
  if (failed.status == SolveStatus::bad_input || failed.status == SolveStatus::too_few) return failed;

  const Vector2d origin = landmarkMean(bearings);
  const std::vector<KnownBearing> local = relativeTo(bearings, origin);
  const std::optional<Pose2> seed = bestSeed(local);
  if (!seed)
  {
    failed.status = solveBearingPoseLinear(local).status;
    return failed;
  }
  std::vector<PoseMeasurement> measurements;
  for (const KnownBearing& b : local)
    measurements.push_back({PoseMeasurement::Kind::bearing, b.landmark, b.bearing, b.std, {}});
  PoseMl result = refinePose(measurements, *seed, options);
  if (result.status != SolveStatus::ok) return result;

  const bool robust = options.loss != Loss::squared;  // a false bearing may then point anywhere
  const auto points_away = [](double r) { return std::abs(r) > 0.5 * kPi; };
  if (!robust && std::any_of(result.residuals.begin(), result.residuals.end(), points_away))
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
