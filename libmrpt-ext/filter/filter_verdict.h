#pragma once

#include <string>

#include "mrpt_ext/filter/modes.h"
#include "mrpt_ext/geometry/verdict.h"

namespace mrpt_ext
{
/// What `ok` promises.
struct VerdictOptions
{
  double min_best_weight = 0.9;         ///< of the best mode
  double max_std_xy = 0.5;              ///< [m] of its position, root of the sum of both variances
  double max_std_phi = degToRad(15.0);  ///< [rad] of its heading
  double min_explained_share = 0.5;     ///< of recent detections, relative to what is expected
};

struct VerdictWithReason
{
  Verdict verdict = Verdict::ambiguous;
  std::string reason;  ///< one short sentence with the figures it rests on
};

/// Judges the posterior from its modes and from the share of recent detections it explains; never from ground truth.
[[nodiscard]] VerdictWithReason judge(const ModeSet& modes, double explained_share, bool lost,
                                      const VerdictOptions& options);
}  // namespace mrpt_ext
