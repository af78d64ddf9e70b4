#include "mrpt_ext/localizers/filter_localizer.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxReportedModes = 20;
}  // namespace

Estimate estimateFrom(const FilterStep& step, double time)
{
  Estimate estimate;
  for (const Mode& mode : step.modes.modes)
  {
    if (mode.weight < kMinReportedWeight || estimate.candidates.size() == kMaxReportedModes) break;
    estimate.candidates.push_back({.pose = mode.pose,
                                   .log_score = std::log(mode.weight),
                                   .weight = mode.weight,
                                   .source = "particles",
                                   .heading_known = step.heading_known});
  }
  if (estimate.candidates.empty()) return estimate;
  estimate.status = SolveStatus::ok;
  estimate.ambiguous = step.verdict == Verdict::ambiguous;
  estimate.point = PoseEstimate{.time = time,
                                .pose = estimate.candidates.front().pose,
                                .heading_known = step.heading_known,
                                .modes = static_cast<int>(estimate.candidates.size()),
                                .best_weight = estimate.candidates.front().weight,
                                .effective_samples = step.effective_ratio,
                                .verdict = step.verdict};
  return estimate;
}

std::optional<HeadingPrior> confidentHeading(const FilterLocalizer& filter)
{
  const FilterStep& step = filter.lastStep();
  if (step.verdict != Verdict::ok || !step.heading_known || step.modes.modes.empty()) return std::nullopt;
  const GaussianPose& pose = step.modes.modes.front().pose;
  return HeadingPrior{pose.mean.phi, std::sqrt(pose.covariance(2, 2))};
}
}  // namespace mrpt_ext
