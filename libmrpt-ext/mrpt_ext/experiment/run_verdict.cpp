#include "mrpt_ext/experiment/run_verdict.h"

#include <algorithm>
#include <array>

namespace mrpt_ext
{
namespace
{
constexpr double kLastSeconds = 10;

const MethodTrajectory* trackOf(const RunRecord& run, const std::string& name)
{
  const auto found = std::find_if(run.methods.begin(), run.methods.end(),
                                  [&](const MethodTrajectory& track) { return track.name == name; });
  return found == run.methods.end() ? nullptr : &*found;
}
}  // namespace

VerdictWithReason verdictOfFilter(const RunRecord& run, const FilterStep& last)
{
  const MethodTrajectory* track = trackOf(run, "particle_filter");
  if (!track || track->points.empty()) return {Verdict::lost, "the filter was given no frame"};
  std::array<std::size_t, 3> count{};
  for (const PoseEstimate& point : track->points)
    if (point.time >= track->points.back().time - kLastSeconds) ++count[static_cast<std::size_t>(point.verdict)];
  const auto usual = static_cast<Verdict>(std::max_element(count.begin(), count.end()) - count.begin());
  VerdictWithReason verdict{std::max(last.verdict, usual), last.reason};
  if (usual > last.verdict)
    verdict.reason = std::string("mostly ") + toString(usual) + " over the last 10 s; at the end: " + last.reason;
  if (run.filter.lost_steps > 0 && verdict.verdict != Verdict::lost)
    verdict.reason += "; lost in " + std::to_string(run.filter.lost_steps) + " of " +
                      std::to_string(track->points.size()) + " frames before";
  return verdict;
}

VerdictWithReason verdictOfClosedForms(const RunRecord& run)
{
  const MethodTrajectory* best = nullptr;
  for (const MethodTrajectory& track : run.methods)
    if (!track.oracle && (!best || track.frames_answered > best->frames_answered)) best = &track;
  if (!best || best->frames_offered == 0) return {Verdict::lost, "no frame with a detection"};
  const std::string figures = best->name + " answers " + std::to_string(best->frames_answered) + " of " +
                              std::to_string(best->frames_offered) + " frames";
  // A best of several candidates is an answer, but not a sure one.
  const auto sure = static_cast<std::size_t>(std::count_if(
      best->points.begin(), best->points.end(), [](const PoseEstimate& p) { return p.verdict == Verdict::ok; }));
  if (2 * sure >= best->frames_offered) return {Verdict::ok, figures};
  if (2 * (best->frames_answered + best->frames_ambiguous) >= best->frames_offered)
    return {Verdict::ambiguous, figures + ", but only " + std::to_string(sure) + " with a single candidate"};
  return {Verdict::lost, figures};
}
}  // namespace mrpt_ext
