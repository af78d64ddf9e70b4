#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Static map of a trial with legend: landmarks with ids, truth, dead reckoning, estimates of the closed forms as dots,
/// the trajectory of the judged method with its first and last estimate, its final modes with 2-sigma ellipses, scale
/// bar; y upwards. The view covers landmarks, truth and that trajectory; estimates outside are cut off and counted
/// below. `record` with aligned odometry, in the map frame.
[[nodiscard]] std::string svgMap(const RunContext& context, const RunRecord& record, const RunScore& score);
}  // namespace mrpt_ext
