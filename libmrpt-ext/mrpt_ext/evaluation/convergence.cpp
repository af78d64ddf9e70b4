#include "mrpt_ext/evaluation/convergence.h"

#include <algorithm>

namespace mrpt_ext
{
bool withinLimits(const ErrorSample& error, const ConvergenceLimits& limits)
{
  return error.position_m <= limits.within_m && (!error.heading_deg || *error.heading_deg <= limits.within_deg);
}

std::optional<double> convergenceStamp(const std::vector<ErrorSample>& errors, const ConvergenceLimits& limits)
{
  std::optional<double> begin;
  for (const ErrorSample& error : errors)
  {
    if (!withinLimits(error, limits))
    {
      begin.reset();
      continue;
    }
    if (!begin) begin = error.stamp;
    if (error.stamp - *begin >= kConvergenceHold) return begin;
  }
  return std::nullopt;
}

double longestTimeOutside(const std::vector<ErrorSample>& errors, double from, const ConvergenceLimits& limits)
{
  constexpr double kStampStandsFor = 1.0;  // [s]
  double longest = 0;
  std::optional<double> begin;
  for (const ErrorSample& error : errors)
  {
    if (error.stamp < from) continue;
    if (withinLimits(error, limits))
    {
      begin.reset();
      continue;
    }
    if (!begin) begin = error.stamp;
    longest = std::max(longest, error.stamp - *begin + kStampStandsFor);
  }
  return longest;
}

bool tellsSuccess(const std::vector<double>& stamps, double log_start, const ConvergenceLimits& limits)
{
  return !stamps.empty() && stamps.front() - log_start <= limits.max_convergence_s &&
         stamps.back() - stamps.front() >= kConvergenceHold;
}

bool isSuccess(const std::vector<ErrorSample>& errors, double log_start, const ConvergenceLimits& limits)
{
  const auto converged = convergenceStamp(errors, limits);
  return converged && *converged - log_start <= limits.max_convergence_s &&
         longestTimeOutside(errors, *converged, limits) <= kMaxTimeOutside;
}
}  // namespace mrpt_ext
