#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

#include <algorithm>

#include "mrpt_ext/correspondence/tree/bearing_least_squares.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
namespace
{
bool withinRange(std::span<const PoseMeasurement> measurements, const Pose2& pose, double max_range)
{
  return std::all_of(measurements.begin(), measurements.end(),
                     [&](const PoseMeasurement& m) { return (m.landmark - pose.position()).norm() <= max_range; });
}

/// A pose near the landmark onto which least squares converges: at the smallest meaningful distance, in the
/// direction of `pose`. Nothing when no landmark is close (a tenth of the distance to the next one).
std::optional<Pose2> startNearLandmark(std::span<const PoseMeasurement> measurements, const Pose2& pose)
{
  double nearest = std::numeric_limits<double>::infinity(), next = nearest;
  Vector2d landmark(0, 0);
  for (const PoseMeasurement& m : measurements)
  {
    const double distance = (m.landmark - pose.position()).norm();
    next = std::min(next, std::max(nearest, distance));
    if (distance < nearest) landmark = m.landmark;
    nearest = std::min(nearest, distance);
  }
  if (!(nearest > 0 && nearest < 0.1 * next)) return std::nullopt;
  const Vector2d position =
      landmark + (pose.position() - landmark) / nearest * std::max(nearest, kClosestApproach * next);
  return Pose2{position.x(), position.y(), pose.phi};
}

/// Maximum-likelihood pose with its residuals. Where least squares converges onto a landmark (from there its
/// bearing is arbitrary), a pose near it.
PoseMl bestPose(std::span<const PoseMeasurement> measurements, const Pose2& start)
{
  PoseMl fit = refinePose(measurements, start);
  if (fit.status != SolveStatus::degenerate) return fit;
  const std::optional<Pose2> near = startNearLandmark(measurements, start);
  if (!near) return fit;
  const std::optional<Matrix3d> covariance = covarianceFromInformation(poseInformation(measurements, *near));
  if (!covariance) return fit;
  fit.status = SolveStatus::ok;
  fit.pose = {*near, *covariance};
  fit.chi2 = 0;
  for (std::size_t i = 0; i < measurements.size(); ++i)
  {
    fit.residuals[i] = residual(measurements[i], *near);
    fit.chi2 += square(fit.residuals[i] / measurements[i].std);
  }
  return fit;
}
}  // namespace

std::optional<Interpretation> verifyInterpretation(const InterpretationProblem& problem,
                                                   const std::vector<int>& assignment, const Pose2& start)
{
  const InterpretationOptions& options = problem.options;
  const double sigma = problem.stdBearing();
  std::vector<PoseMeasurement> measurements;
  for (std::size_t i = 0; i < assignment.size(); ++i)
    if (assignment[i] >= 0)
      measurements.push_back({PoseMeasurement::Kind::bearing,
                              problem.landmarks[static_cast<std::size_t>(assignment[i])],
                              problem.bearings[i],
                              sigma,
                              {}});
  const PoseMl fit = bestPose(measurements, start);
  if (fit.status != SolveStatus::ok) return std::nullopt;

  Interpretation result;
  for (const double r : fit.residuals) result.max_residual = std::max(result.max_residual, std::abs(r));
  if (result.max_residual > options.max_residual) return std::nullopt;
  if (options.area && !options.area->contains(fit.pose.mean.position())) return std::nullopt;
  if (options.max_range && !withinRange(measurements, fit.pose.mean, *options.max_range)) return std::nullopt;

  result.assignment = assignment;
  result.pose = fit.pose;
  result.matched = static_cast<int>(measurements.size());
  const double clutter = options.clutter_probability;
  const double per_match = std::log((1 - clutter) / static_cast<double>(problem.landmarks.size())) -
                           0.5 * std::log(kTwoPi) - std::log(sigma);
  const double unmatched = static_cast<double>(assignment.size() - measurements.size());
  result.log_likelihood =
      result.matched * per_match - 0.5 * fit.chi2 + (unmatched > 0 ? unmatched * std::log(clutter / kTwoPi) : 0);
  return result;
}
}  // namespace mrpt_ext
