#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Charts of a trial with their legends; empty when there is nothing to draw.

/// Position error of every method: curves for those that carry their pose, dots for closed forms.
[[nodiscard]] std::string positionErrorChart(const RunContext& context, const RunScore& score);
/// The same for the heading.
[[nodiscard]] std::string headingErrorChart(const RunContext& context, const RunScore& score);
/// Weight of the reported mode and effective sample ratio of the judged method, with its re-seeds and the times at
/// which its verdict was ambiguous or lost.
[[nodiscard]] std::string confidenceChart(const RunContext& context, const RunRecord& record, const RunScore& score);
/// Normalised estimation error squared of the judged method, with the band that 95 % of honest estimates lie in.
[[nodiscard]] std::string neesChart(const RunContext& context, const RunScore& score);
}  // namespace mrpt_ext
