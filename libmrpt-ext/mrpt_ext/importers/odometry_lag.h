#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mrpt_ext
{
/// Delay of readings against odometry.
struct OdometryLag
{
  double median = 0, largest = 0;  ///< [s] age of the newest odometry record at a reading
  std::size_t before = 0;          ///< readings before the first record
  std::size_t after = 0;           ///< readings after the last one; they count with their age, too
};

/// Both in ascending order [s]. Nothing without odometry or when all readings come before it.
[[nodiscard]] std::optional<OdometryLag> odometryLag(const std::vector<double>& odometry,
                                                     const std::vector<double>& readings);

[[nodiscard]] std::string describe(const OdometryLag& lag);
}  // namespace mrpt_ext
