#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// A time in which a verdict held.
struct VerdictSpan
{
  double from = 0, to = 0;  ///< [s] since `start`
};

/// When the verdict of the trajectory was this one; spans closer than `resolution` [s] are joined, shorter ones
/// widened.
[[nodiscard]] std::vector<VerdictSpan> verdictSpans(const MethodTrajectory& trajectory, Verdict verdict, double start,
                                                    double resolution);
}  // namespace mrpt_ext
