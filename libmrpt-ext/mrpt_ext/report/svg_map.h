#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Map of a trial with legend: landmarks with ids, truth, dead reckoning, estimates of the closed forms as dots, the
/// judged method's path with start and end, its modes at the end with 2-sigma ellipses, scale bar; y upwards.
/// The view covers landmarks, truth and the judged path; what lies outside is cut off and counted below.
/// `record` with aligned odometry, so that it lies in the map frame.
[[nodiscard]] std::string svgMap(const RunContext& context, const RunRecord& record, const RunScore& score);
}  // namespace mrpt_ext
