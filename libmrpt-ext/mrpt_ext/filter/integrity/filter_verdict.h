#pragma once

#include <string>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// What `ok` promises.
struct VerdictOptions
{
  double min_best_weight = 0.9;         ///< of the best mode
  double max_std_xy = 0.5;              ///< [m] of its position, root of the sum of both variances
  double max_std_phi = degToRad(15.0);  ///< [rad] of its heading
  double min_explained_share = 0.8;     ///< of recent detections, relative to what the configuration expects
  double min_effective = 15;            ///< effective particles: fewer cannot tell how wide the posterior is
};

struct VerdictWithReason
{
  Verdict verdict = Verdict::ambiguous;
  std::string reason;  ///< one short sentence with the figures it rests on
};

/// What the verdict rests on beside the modes.
struct VerdictEvidence
{
  double explained_share = 1;  ///< of recent detections, relative to what is expected
  bool lost = false;           ///< the recovery monitor's alarm
  double effective = 1e9;      ///< effective number of particles
  double log_odds = 0;         ///< of the place against a chance fit, from fresh looks
  bool proven = true;          ///< they suffice
  bool contradicted = false;   ///< all that was seen along the way fits other places better
};

/// True when the posterior is one sharp place, whether the detections agree with it or not.
[[nodiscard]] bool isUnimodal(const ModeSet& modes, const VerdictOptions& options);

/// Judges the posterior from its modes and from the share of recent detections it explains; never from ground truth.
[[nodiscard]] VerdictWithReason judge(const ModeSet& modes, const VerdictEvidence& evidence,
                                      const VerdictOptions& options);
}  // namespace mrpt_ext
