#include "mrpt_ext/correspondence/tree/interpretation_refinement.h"

#include "mrpt_ext/solvers/bearing_pose_ml.h"

namespace mrpt_ext
{
namespace
{
/// Start of the descent; `ok` is false when the bearings do not determine one.
struct Start
{
  Pose2 pose;
  bool ok = true;
};

Start startFrom(std::span<const MatchedBearing> matched, const RayCrossing& base)
{
  if (base.outcome == CrossingOutcome::pose)
  {
    const Vector2d& reference = matched[0].landmark;
    return {{reference.x() + base.x, reference.y() + base.y, std::atan2(-base.y, -base.x) - matched[0].bearing}};
  }
  std::vector<KnownBearing> known;
  for (const MatchedBearing& m : matched) known.push_back({m.landmark, m.bearing, 1});
  const PoseMl fit = solveBearingPoseMl(known);
  return {fit.pose.mean, fit.status == SolveStatus::ok};
}

std::optional<Interpretation> interpretFrom(const Pose2& start, const InterpretationProblem& problem,
                                            const std::vector<int>& assignment, std::span<const MatchedBearing> matched)
{
  const BearingFit fit = fitBearings(matched, start);
  if (fit.max_residual > problem.options.max_residual * 1.01) return std::nullopt;
  return verifyInterpretation(problem, assignment, fit.pose);
}
}  // namespace

std::optional<Interpretation> refineInterpretation(const InterpretationProblem& problem,
                                                   const std::vector<int>& assignment,
                                                   std::span<const MatchedBearing> matched, const RayCrossing& base)
{
  const Start start = startFrom(matched, base);
  if (start.ok)
    if (auto found = interpretFrom(start.pose, problem, assignment, matched)) return found;
  if (matched.size() < 4) return std::nullopt;
  // A close landmark has a minimum of its own, which no start elsewhere leads to.
  const bool anywhere = base.outcome == CrossingOutcome::open;
  const double reach = anywhere ? std::numeric_limits<double>::infinity() : base.slack;
  for (std::size_t i = 0; i < matched.size(); ++i)
  {
    const std::optional<Pose2> near =
        startNearLandmark(matched, i, start.pose.position(), reach, problem.options.max_residual);
    if (!near) continue;
    if (auto found = interpretFrom(*near, problem, assignment, matched)) return found;
  }
  return std::nullopt;
}
}  // namespace mrpt_ext
