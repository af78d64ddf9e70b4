#include "mrpt_ext/filter/integrity/filter_verdict.h"

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
/// Standard deviations of a mode: position [m], both axes together, and heading [rad].
struct Spread
{
  double xy = 0, phi = 0;
};

Spread spreadOf(const Mode& mode)
{
  const Matrix3d& C = mode.pose.covariance;
  return {std::sqrt(C(0, 0) + C(1, 1)), std::sqrt(C(2, 2))};
}

// Comparisons are written so that a weight or spread that is no number fails.
bool isDominant(const Mode& mode, const VerdictOptions& options) { return mode.weight >= options.min_best_weight; }

bool isPrecise(const Spread& spread, const VerdictOptions& options)
{
  return spread.xy <= options.max_std_xy && spread.phi <= options.max_std_phi;
}
}  // namespace

bool isUnimodal(const ModeSet& modes, const VerdictOptions& options)
{
  return !modes.modes.empty() && isDominant(modes.modes.front(), options) &&
         isPrecise(spreadOf(modes.modes.front()), options);
}

VerdictWithReason judge(const ModeSet& modes, const VerdictEvidence& evidence, const VerdictOptions& options)
{
  if (modes.modes.empty()) return {Verdict::lost, "no particle left"};
  const double percent = 100 * evidence.explained_share;
  if (evidence.lost)
    return {Verdict::lost,
            text("the best pose explains only %.0f %% of the recent detections expected of it", percent)};
  const Mode& best = modes.modes.front();
  const Spread spread = spreadOf(best);
  if (!isDominant(best, options))
    return {Verdict::ambiguous,
            text("%zu places explain the detections, the best has weight %.2f", modes.modes.size(), best.weight)};
  if (!isPrecise(spread, options))
    return {Verdict::ambiguous,
            text("the pose is not sharp yet: %.2f m and %.1f deg standard deviation", spread.xy, radToDeg(spread.phi))};
  if (!(evidence.explained_share >= options.min_explained_share))
    return {Verdict::ambiguous,
            text("one place, but it explains only %.0f %% of the recent detections expected of it", percent)};
  if (!(evidence.effective >= options.min_effective))
    return {Verdict::ambiguous, text("one place, but it rests on %.0f effective particles", evidence.effective)};
  if (!evidence.proven)
    return {
        Verdict::ambiguous,
        text("one place, but fresh readings do not yet tell it from a chance fit (log odds %.1f)", evidence.log_odds)};
  if (evidence.contradicted)
    return {Verdict::ambiguous, "one place, but what was seen along the way behind fits another one better"};
  return {Verdict::ok, text("one place, weight %.2f, %.3f m and %.1f deg standard deviation, explains %.0f %% of the "
                            "recent detections expected of it",
                            best.weight, spread.xy, radToDeg(spread.phi), percent)};
}
}  // namespace mrpt_ext
