#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// What `ok` requires of the best mode.
struct VerdictOptions
{
  double min_best_weight = 0.995;       ///< hypotheses that are injected to verify a mode have less than the rest
  double max_std_xy = 0.5;              ///< [m] standard deviation of the position: root of the sum of both variances
  double max_std_phi = degToRad(15.0);  ///< [rad] of the heading; infinite: it is not observable and does not count

  /// Weight of a mode that is followed as the only one, if not enough for `ok`.
  [[nodiscard]] double dominantWeight() const { return std::min(0.9, min_best_weight); }
};

struct VerdictWithReason
{
  Verdict verdict = Verdict::ambiguous;
  std::string reason;  ///< one short sentence with the numbers it rests on
};

/// What the verdict rests on beside the modes.
struct VerdictEvidence
{
  double inlier_ratio = 1;     ///< of recent detections, relative to the expected one
  bool lost = false;           ///< the fast inlier ratio is below the limit for `lost`
  double effective = 1e9;      ///< effective number of particles
  double log_odds = 0;         ///< of the mode against the null hypothesis (sequential_pose_test.h)
  bool verified = true;        ///< ... are enough
  std::optional<Pose2> rival;  ///< from where the map looks the same, if only that speaks against the mode
  bool contradicted = false;   ///< the recent trajectory fits another pose better
  bool supported = true;       ///< by landmarks, not by odometry alone (pose_support.h, slip_test.h)
};

/// True when the best mode has the weight of one that is followed as the only one.
[[nodiscard]] bool isDominant(const ModeSet& modes, const VerdictOptions& options);

/// True when the posterior is one precise mode, whether the detections agree with it or not.
[[nodiscard]] bool isUnimodal(const ModeSet& modes, const VerdictOptions& options);

/// Judges the posterior from its modes and from the inlier ratio; never from ground truth.
[[nodiscard]] VerdictWithReason judge(const ModeSet& modes, const VerdictEvidence& evidence,
                                      const VerdictOptions& options);
}  // namespace mrpt_ext
