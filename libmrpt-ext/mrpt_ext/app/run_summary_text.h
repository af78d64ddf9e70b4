#pragma once

#include <string>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// The first screen of a run: map, log, truth, what is used and what is ignored and why.
[[nodiscard]] std::string inputText(const LocalizationInput& input);

/// The Cramer-Rao limit beside which the closed forms of independent frames are to be read; empty without truth.
[[nodiscard]] std::string boundText(const LocalizationInput& input);

/// One line for every change of the filter's verdict: time since the start, verdict, pose, number of modes.
[[nodiscard]] std::string verdictText(const RunRecord& record, double start_time);

/// When and how the filter found its place: number of places at the start, and when one was left.
[[nodiscard]] std::string ambiguityText(const RunRecord& record, double start_time);
}  // namespace mrpt_ext
