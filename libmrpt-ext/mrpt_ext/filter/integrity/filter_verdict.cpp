#include "mrpt_ext/filter/integrity/filter_verdict.h"

#include <cmath>

#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/geometry/min_inlier_ratio.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinEffectiveForOk = 15;  // particles; fewer cannot estimate the covariance

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
bool isPrecise(const Spread& spread, const VerdictOptions& options)
{
  return spread.xy <= options.max_std_xy && spread.phi <= options.max_std_phi;
}

bool headingCounts(const VerdictOptions& options) { return std::isfinite(options.max_std_phi); }

std::string headingText(const Spread& spread, const VerdictOptions& options)
{
  return headingCounts(options) ? formatted(" and %.1f deg", radToDeg(spread.phi)) : ", heading unknown";
}

/// Names the limits with their keys: a sensor that cannot give that needs others.
std::string whyImprecise(const Spread& spread, const VerdictOptions& options)
{
  const std::string limits = headingCounts(options) ? formatted("%.2f m and %.1f deg (ok_max_std_m, ok_max_std_deg)",
                                                                options.max_std_xy, radToDeg(options.max_std_phi))
                                                    : formatted("%.2f m (ok_max_std_m)", options.max_std_xy);
  return formatted("the pose is not precise yet: standard deviation %.2f m", spread.xy) + headingText(spread, options) +
         ", `ok` asks for " + limits;
}
}  // namespace

bool isDominant(const ModeSet& modes, const VerdictOptions& options)
{
  return !modes.modes.empty() && modes.modes.front().weight >= options.dominantWeight();
}

bool isUnimodal(const ModeSet& modes, const VerdictOptions& options)
{
  return isDominant(modes, options) && isPrecise(spreadOf(modes.modes.front()), options);
}

VerdictWithReason judge(const ModeSet& modes, const VerdictEvidence& evidence, const VerdictOptions& options)
{
  if (modes.modes.empty()) return {Verdict::lost, "no particles left"};
  const double percent = 100 * evidence.inlier_ratio;
  if (evidence.lost)
    return {Verdict::lost,
            formatted("inlier ratio only %.0f %% of the expected value over recent detections", percent)};
  const Mode& best = modes.modes.front();
  const Spread spread = spreadOf(best);
  const auto ambiguous = [](std::string reason) { return VerdictWithReason{Verdict::ambiguous, std::move(reason)}; };
  if (!(best.weight >= options.min_best_weight))
    return ambiguous(formatted("%zu modes, the best has weight %.3f", modes.modes.size(), best.weight));
  if (!isPrecise(spread, options)) return ambiguous(whyImprecise(spread, options));
  if (!(evidence.inlier_ratio >= kMinInlierRatio))
    return ambiguous(
        formatted("one mode, but inlier ratio only %.0f %% of the expected value over recent detections", percent));
  if (!(evidence.effective >= kMinEffectiveForOk))
    return ambiguous(formatted("one mode, but only %.0f effective particles", evidence.effective));
  if (!evidence.verified && evidence.rival)
    return ambiguous(
        formatted("one mode, but the map looks alike from x %.2f m, y %.2f m, heading %.0f deg: log odds %.1f "
                  "against that, %.0f needed",
                  evidence.rival->x, evidence.rival->y, radToDeg(evidence.rival->phi), evidence.log_odds,
                  SequentialPoseTest::kAcceptLogOdds));
  if (!evidence.verified)
    return ambiguous(formatted("one mode, not verified yet: log odds %.1f against the null hypothesis, %.0f needed",
                               evidence.log_odds, SequentialPoseTest::kAcceptLogOdds));
  if (evidence.contradicted) return ambiguous("one mode, but the recent trajectory fits another pose better");
  if (!evidence.supported)
    return ambiguous(
        "one mode, but odometry alone led here from the last landmark, and what is seen does not prove it");
  return {Verdict::ok, formatted("one mode, weight %.2f, standard deviation %.3f m%s, inlier ratio %.0f %% of the "
                                 "expected value over recent detections",
                                 best.weight, spread.xy, headingText(spread, options).c_str(), percent)};
}
}  // namespace mrpt_ext
