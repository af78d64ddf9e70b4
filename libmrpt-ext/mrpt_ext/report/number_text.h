#pragma once

#include <string>

#include "mrpt_ext/evaluation/detection_gaps.h"
#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Stands for a number that does not exist.
inline constexpr const char* kNoNumber = "-";

/// Fixed decimals, or kNoNumber.
[[nodiscard]] std::string numberText(const OptionalNumber& number, int decimals);
/// About four significant digits without an exponent: 0.123, 12.34, 1234.
[[nodiscard]] std::string magnitudeText(const OptionalNumber& number);
/// A share as "85 %", or kNoNumber; "100 %" only when it is all, "0 %" only when it is none.
[[nodiscard]] std::string percentText(const OptionalNumber& share);
/// A count, with a decimal only when it is a median between two counts.
[[nodiscard]] std::string countText(const OptionalNumber& number);
/// "1 estimate", "2 estimates".
[[nodiscard]] std::string countedText(const OptionalNumber& number, const std::string& what);

/// The method with the lowest position RMSE, without oracles; null without any RMSE.
[[nodiscard]] const MethodScore* bestMethod(const RunScore& score);

/// The score of the judged method; null without one.
[[nodiscard]] const MethodScore* judgedScore(const RunScore& score);

/// "particle_filter: position RMSE 0.008 m with detections, 0.352 m without any for more than 2 s"; empty without an
/// error.
[[nodiscard]] std::string detectionSplitText(const RunScore& score);

/// One sentence on convergence and success of the trial, or on success rate, lost runs and spread of the trials.
[[nodiscard]] std::string outcomeText(const RunScore& score);
}  // namespace mrpt_ext
