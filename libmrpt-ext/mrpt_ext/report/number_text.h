#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// What people read where a figure does not exist.
inline constexpr const char* kNoNumber = "-";

/// Fixed decimals, or kNoNumber.
[[nodiscard]] std::string numberText(const OptionalNumber& figure, int decimals);
/// About four significant digits without an exponent: 0.123, 12.34, 1234.
[[nodiscard]] std::string magnitudeText(const OptionalNumber& figure);
/// A share as "85 %", or kNoNumber; "100 %" only when it is all, "0 %" only when it is none.
[[nodiscard]] std::string percentText(const OptionalNumber& share);
/// A count, with a decimal only when it is a median between two counts.
[[nodiscard]] std::string countText(const OptionalNumber& figure);

/// The method with the least position RMSE that did not use the truth for its choice; nothing without any RMSE.
[[nodiscard]] const MethodScore* bestMethod(const RunScore& score);

/// One sentence on convergence and success of the trial, or on success rate, lost runs and spread of the trials.
[[nodiscard]] std::string outcomeText(const RunScore& score);
}  // namespace mrpt_ext
