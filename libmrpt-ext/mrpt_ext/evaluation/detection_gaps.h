#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// Without a detection for longer than this, a robot counts as blind [s].
inline constexpr double kBlindAfter = 2;

/// Errors apart by whether there was anything to localize with.
struct ErrorsByDetections
{
  std::vector<ErrorSample> with_detections;  ///< the last detection is at most kBlindAfter old
  std::vector<ErrorSample> blind;
};

/// `errors` ordered by stamp; the frames with detections are those of RunContext::geometry.
[[nodiscard]] ErrorsByDetections splitByDetections(const std::vector<ErrorSample>& errors, const RunContext& context);
}  // namespace mrpt_ext
