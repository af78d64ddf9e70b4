#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// What a run took over from its log, beside the run as configured, for the console. Empty without a calibration.
[[nodiscard]] std::string calibrationText(const RunContext& context, const RunScore& score);
/// The same as a section of the report.
[[nodiscard]] std::string calibrationSection(const RunContext& context, const RunScore& score);
/// The row of the run itself: the second pass.
[[nodiscard]] CalibrationRow calibratedRow(const RunContext& context, const RunScore& score);
}  // namespace mrpt_ext
