#pragma once

#include <string>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// The first screen of a run: map, log, truth, how many observations are used, and why others are not.
[[nodiscard]] std::string inputText(const LocalizationInput& input);

/// The Cramer-Rao bound of independent frames, to compare the closed forms with; empty without truth.
[[nodiscard]] std::string boundText(const LocalizationInput& input);

/// One line for every change of the filter's verdict: time since the start, verdict, pose, number of modes.
[[nodiscard]] std::string verdictText(const RunRecord& record, double start_time);

/// Global localization in two lines: number of hypotheses at the start, and when the verdict became `ok`.
[[nodiscard]] std::string ambiguityText(const RunRecord& record, double start_time);
}  // namespace mrpt_ext
