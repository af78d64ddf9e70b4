#include "mrpt_ext/experiment/run_verdict.h"

#include <algorithm>
#include <array>

#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLastSeconds = 10;

const MethodTrajectory* trajectoryOf(const RunRecord& run, const std::string& name)
{
  const auto found = std::find_if(run.methods.begin(), run.methods.end(),
                                  [&](const MethodTrajectory& trajectory) { return trajectory.name == name; });
  return found == run.methods.end() ? nullptr : &*found;
}
}  // namespace

VerdictWithReason verdictOfFilter(const RunRecord& run, const FilterStep& last)
{
  const MethodTrajectory* trajectory = trajectoryOf(run, "particle_filter");
  if (!trajectory || trajectory->points.empty()) return {Verdict::lost, "no frame reached the filter"};
  std::array<std::size_t, 3> count{};
  for (const PoseEstimate& point : trajectory->points)
    if (point.time >= trajectory->points.back().time - kLastSeconds) ++count[static_cast<std::size_t>(point.verdict)];
  const auto usual = static_cast<Verdict>(std::max_element(count.begin(), count.end()) - count.begin());
  VerdictWithReason verdict{std::max(last.verdict, usual), last.reason};
  if (usual > last.verdict)
    verdict.reason = std::string("mostly ") + toString(usual) + " over the last 10 s; at the end: " + last.reason;
  if (run.filter.lost_steps > 0 && verdict.verdict != Verdict::lost)
    verdict.reason += "; lost in " + std::to_string(run.filter.lost_steps) + " of " +
                      std::to_string(trajectory->points.size()) + " frames before";
  if (run.filter.stopped_searches > 0)
    verdict.reason += "; in " + countOf(run.filter.stopped_searches, "step") +
                      " the search for the pose was ended by its work limit: poses may be missing";
  if (run.filter.detections_left_out > 0)
    verdict.reason += "; " + std::to_string(run.filter.detections_left_out) +
                      " detections were left out of frames with more than a localizer works with";
  return verdict;
}

VerdictWithReason verdictOfClosedForms(const RunRecord& run)
{
  const MethodTrajectory* best = nullptr;
  for (const MethodTrajectory& trajectory : run.methods)
    if (!trajectory.oracle && (!best || trajectory.frames_answered > best->frames_answered)) best = &trajectory;
  if (!best || best->frames_offered == 0) return {Verdict::lost, "no frame with a detection"};
  const std::string figures = best->name + " answers " + std::to_string(best->frames_answered) + " of " +
                              std::to_string(best->frames_offered) + " frames";
  // The best of several candidates is an answer, but an ambiguous one.
  const auto unambiguous = static_cast<std::size_t>(std::count_if(
      best->points.begin(), best->points.end(), [](const PoseEstimate& p) { return p.verdict == Verdict::ok; }));
  if (2 * unambiguous >= best->frames_offered) return {Verdict::ok, figures};
  if (2 * (best->frames_answered + best->frames_ambiguous) >= best->frames_offered)
    return {Verdict::ambiguous,
            figures + ", but only " + std::to_string(unambiguous) + " with a single, precise candidate"};
  return {Verdict::lost, figures};
}
}  // namespace mrpt_ext
