#pragma once

#include <mrpt/system/datetime.h>

#include <cmath>
#include <cstdint>

namespace mrpt_ext
{
/// MRPT counts ticks of 100 ns since 1601. Both conversions round to the nearest value, so that times with up to seven
/// decimals (and below 2^53 ticks) survive both conversions; mrpt::Clock::fromDouble() truncates instead.
inline constexpr double kTicksPerSecond = 1e7;

inline constexpr std::int64_t kTicksOfUnixEpoch = 116'444'736'000'000'000;

/// Unix time [s] of a valid stamp. Unsigned difference: a damaged stamp may be any number.
[[nodiscard]] inline double secondsOf(const mrpt::system::TTimeStamp& stamp)
{
  const auto ticks = static_cast<std::uint64_t>(stamp.time_since_epoch().count());
  return static_cast<double>(static_cast<std::int64_t>(ticks - kTicksOfUnixEpoch)) / kTicksPerSecond;
}

/// Stamp of a Unix time [s].
[[nodiscard]] inline mrpt::system::TTimeStamp timestampOf(double seconds)
{
  const std::int64_t ticks = std::llround(seconds * kTicksPerSecond) + kTicksOfUnixEpoch;
  return mrpt::system::TTimeStamp(mrpt::system::TTimeStamp::duration(ticks));
}

[[nodiscard]] inline bool isValid(const mrpt::system::TTimeStamp& stamp) { return stamp != INVALID_TIMESTAMP; }
}  // namespace mrpt_ext
