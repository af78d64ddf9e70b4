#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// Within which errors a filter counts as converged.
struct ConvergenceLimits
{
  double within_m = 0.5;          ///< position error [m]
  double within_deg = 15;         ///< heading error [deg], where the truth has a heading
  double max_convergence_s = 60;  ///< [s] since the start of the log
};

/// Time within the limits that counts as converged [s].
inline constexpr double kConvergenceHold = 5;
/// Longest time outside the limits that a success allows afterwards [s].
inline constexpr double kMaxTimeOutside = 10;

[[nodiscard]] bool withinLimits(const ErrorSample& error, const ConvergenceLimits& limits);

/// Stamp of the first sample of an unbroken row of samples within the limits that lasts at least
/// kConvergenceHold. Nothing if the log or the truth ends before that.
[[nodiscard]] std::optional<double> convergenceStamp(const std::vector<ErrorSample>& errors,
                                                     const ConvergenceLimits& limits);

/// Longest time outside the limits in a row at or after `from` [s]: from the first to the last sample of the row,
/// plus the one second that a stamp stands for. 0 when never outside.
[[nodiscard]] double longestTimeOutside(const std::vector<ErrorSample>& errors, double from,
                                        const ConvergenceLimits& limits);

/// True when the truth can tell a success: its stamps begin within max_convergence_s of the start of the log and span
/// at least kConvergenceHold. `stamps` [s]: at which the errors are judged.
[[nodiscard]] bool tellsSuccess(const std::vector<double>& stamps, double log_start, const ConvergenceLimits& limits);

/// Converged within max_convergence_s of the start of the log and never outside longer than kMaxTimeOutside.
[[nodiscard]] bool isSuccess(const std::vector<ErrorSample>& errors, double log_start, const ConvergenceLimits& limits);
}  // namespace mrpt_ext
