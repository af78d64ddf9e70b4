#pragma once

#include <string_view>

namespace mrpt_ext
{
/// Why a solver has, or has not, a solution. Failures are values: solvers neither throw nor return NaN.
enum class SolveStatus
{
  ok,          ///< at least one solution
  too_few,     ///< fewer measurements than the problem needs
  degenerate,  ///< the geometry leaves a direction undetermined (e.g. all on one circle, coincident centres)
  behind,      ///< lines meet, but a directed bearing points away from its landmark
  none,        ///< the measurements contradict each other: no pose fits them
  bad_input    ///< non-finite, negative or mismatched input
};

[[nodiscard]] constexpr std::string_view toString(SolveStatus status)
{
  switch (status)
  {
    case SolveStatus::ok:
      return "ok";
    case SolveStatus::too_few:
      return "too_few";
    case SolveStatus::degenerate:
      return "degenerate";
    case SolveStatus::behind:
      return "behind";
    case SolveStatus::none:
      return "none";
    case SolveStatus::bad_input:
      return "bad_input";
  }
  return "unknown";
}
}  // namespace mrpt_ext
