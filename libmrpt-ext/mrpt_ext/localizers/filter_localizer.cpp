#include "mrpt_ext/localizers/filter_localizer.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxReportedModes = 20;
}  // namespace

Estimate estimateFrom(std::span<const Mode> heaviest_first, Verdict verdict, bool heading_known,
                      const std::string& source, double time)
{
  Estimate estimate;
  for (const Mode& mode : heaviest_first)
    if (mode.weight >= kMinReportedWeight)
      estimate.candidates.push_back({.pose = mode.pose,
                                     .log_score = std::log(mode.weight),
                                     .weight = mode.weight,
                                     .source = source,
                                     .heading_known = heading_known});
  if (estimate.candidates.empty()) return estimate;
  estimate.status = SolveStatus::ok;
  estimate.ambiguous = verdict == Verdict::ambiguous;
  estimate.point = PoseEstimate{.time = time,
                                .pose = estimate.candidates.front().pose,
                                .heading_known = heading_known,
                                .modes = static_cast<int>(estimate.candidates.size()),
                                .best_weight = estimate.candidates.front().weight,
                                .verdict = verdict};
  return estimate;
}

Estimate estimateFrom(const FilterStep& step, double time)
{
  const std::span<const Mode> modes(step.modes.modes);
  Estimate estimate = estimateFrom(modes.first(std::min(modes.size(), kMaxReportedModes)), step.verdict,
                                   step.heading_known, "particles", time);
  if (estimate.point) estimate.point->effective_samples = step.effective_ratio;
  return estimate;
}

std::optional<HeadingPrior> confidentHeading(const FilterLocalizer& filter)
{
  const FilterStep& step = filter.lastStep();
  if (step.verdict != Verdict::ok || !step.heading_known || step.modes.modes.empty()) return std::nullopt;
  return headingOf(step.modes.modes.front().pose);
}
}  // namespace mrpt_ext
