#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Residuals of every landmark: mean and spread in units of their standard deviation, inlier rate as the size of the
/// mark. Empty without residuals, and with so many landmarks that the drawing could not show them.
[[nodiscard]] std::string residualChart(const RunScore& score);
}  // namespace mrpt_ext
