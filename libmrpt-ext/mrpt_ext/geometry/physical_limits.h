#pragma once

#include <string>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// What can be measured at all. Readers of files refuse everything beyond, so that squares and products of what they
/// let in are finite, and nothing behind them has to check again.
inline constexpr double kLargestCoordinate = 1e8;  ///< [m] coordinates, ranges; projected maps of the earth need 1e7
inline constexpr double kLargestTime = 1e11;       ///< [s] either way of the Unix epoch: what MRPT's stamps hold
inline constexpr double kLongestGap = 30 * 86400;  ///< [s] between two records of a log

/// False for what is not finite.
[[nodiscard]] inline bool isCoordinate(double value)
{
  return value >= -kLargestCoordinate && value <= kLargestCoordinate;
}
[[nodiscard]] inline bool isTime(double value) { return value >= -kLargestTime && value <= kLargestTime; }

/// What of a record is beyond these limits and what is expected; empty when nothing is. Detections are not looked at:
/// single ones that cannot be used are left out and counted.
[[nodiscard]] std::string whyImpossible(const Record& record);
}  // namespace mrpt_ext
