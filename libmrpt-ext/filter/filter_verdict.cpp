#include "mrpt_ext/filter/filter_verdict.h"

#include <cmath>
#include <cstdio>

namespace mrpt_ext
{
namespace
{
template <typename... Values>
std::string text(const char* format, Values... values)
{
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer), format, values...);
  return buffer;
}
}  // namespace

VerdictWithReason judge(const ModeSet& modes, const VerdictEvidence& evidence, const VerdictOptions& options)
{
  if (modes.modes.empty()) return {Verdict::lost, "no particle left"};
  const double percent = 100 * evidence.explained_share;
  if (evidence.lost)
    return {Verdict::lost,
            text("the best pose explains only %.0f %% of the recent detections expected of it", percent)};
  const Mode& best = modes.modes.front();
  const double std_xy = std::sqrt(best.pose.covariance(0, 0) + best.pose.covariance(1, 1));
  const double std_phi = std::sqrt(best.pose.covariance(2, 2));
  if (!(best.weight >= options.min_best_weight))
    return {Verdict::ambiguous,
            text("%zu places explain the detections, the best has weight %.2f", modes.modes.size(), best.weight)};
  if (!(std_xy <= options.max_std_xy && std_phi <= options.max_std_phi))
    return {Verdict::ambiguous,
            text("the pose is not sharp yet: %.2f m and %.1f deg standard deviation", std_xy, radToDeg(std_phi))};
  if (!(evidence.explained_share >= options.min_explained_share))
    return {Verdict::ambiguous,
            text("one place, but it explains only %.0f %% of the recent detections expected of it", percent)};
  if (!(evidence.effective >= options.min_effective))
    return {Verdict::ambiguous, text("one place, but it rests on %.0f effective particles", evidence.effective)};
  return {Verdict::ok, text("one place, weight %.2f, %.3f m and %.1f deg standard deviation, explains %.0f %% of the "
                            "recent detections expected of it",
                            best.weight, std_xy, radToDeg(std_phi), percent)};
}
}  // namespace mrpt_ext
