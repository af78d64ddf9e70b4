#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// A sentence for each method that tracks beside the judged one: as accurate, more or less accurate, or not
/// distinguishable, and at which relative cost. Two methods are as accurate as each other when the 95 %
/// interval of the ratio of their RMSE stays within 5 % of one.
[[nodiscard]] std::vector<std::string> comparisonSentences(const RunScore& score);

/// The posterior Cramer-Rao bound and the RMSE of the methods that track relative to it, or the reason why there is
/// none. Empty where it does not apply.
[[nodiscard]] std::string limitText(const RunScore& score);
}  // namespace mrpt_ext
