#include "mrpt_ext/localizers/closed_form_localizer.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/hypotheses/window_readings.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameScore = 1e-6;                    // log-scores closer than this are equal
constexpr double kAnyHeadingVariance = kPi * kPi / 3;  // of a uniform heading
constexpr double kMostErrors = 2;                      // standard deviations that hold 95 % of the errors

bool isWithin(const ErrorLimits& limits, const PoseHypothesis& candidate)
{
  const Matrix3d& C = candidate.pose.covariance;
  return kMostErrors * std::sqrt(C(0, 0) + C(1, 1)) <= limits.position &&
         (!candidate.heading_known || kMostErrors * std::sqrt(C(2, 2)) <= limits.heading);
}
}  // namespace

Estimate estimateFrom(ClosedFormResult result, double time, const ErrorLimits& limits)
{
  Estimate estimate;
  estimate.status = result.status;
  rankByScore(result.candidates);
  estimate.candidates = std::move(result.candidates);
  if (estimate.candidates.empty()) return estimate;
  const PoseHypothesis& best = estimate.candidates.front();
  estimate.ambiguous = estimate.candidates.size() > 1 && best.log_score - estimate.candidates[1].log_score < kSameScore;
  if (estimate.ambiguous) return estimate;
  PoseEstimate point{.time = time, .pose = best.pose, .heading_known = best.heading_known};
  if (!best.heading_known) point.pose.covariance(2, 2) = kAnyHeadingVariance;
  point.modes = static_cast<int>(estimate.candidates.size());
  point.best_weight = best.weight;
  const bool only_one = estimate.candidates.size() == 1 && estimate.status == SolveStatus::ok && result.unique;
  point.verdict = only_one && isWithin(limits, best) ? Verdict::ok : Verdict::ambiguous;
  estimate.point = point;
  return estimate;
}

Estimate ClosedFormLocalizer::process(const Frame& frame)
{
  const std::optional<Frame> bounded = boundedFrame(frame, isWindow(frame.readings) ? kMostJoined : kMostDetections);
  return estimateFrom(method_(bounded ? *bounded : frame), frame.time, limits_);
}
}  // namespace mrpt_ext
