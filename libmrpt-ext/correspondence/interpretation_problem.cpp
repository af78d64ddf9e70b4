#include "mrpt_ext/correspondence/interpretation_problem.h"

#include <algorithm>

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
}  // namespace

std::optional<Interpretation> judgeInterpretation(const InterpretationProblem& problem,
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
  const PoseMl fit = refinePose(measurements, start);
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
