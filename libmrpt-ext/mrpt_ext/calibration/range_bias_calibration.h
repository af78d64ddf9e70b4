#pragma once

#include <vector>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A range between one of several radios on the robot and one of the radios of the map.
struct RadioRange
{
  std::size_t sensor = 0, landmark = 0;  ///< numbers of the two radios, from 0 on
  Vector2d position{0, 0};               ///< of the landmark, world frame [m]
  Vector2d offset{0, 0};                 ///< of the sensor, robot frame [m]
  double height = 0;                     ///< [m] of the landmark above the sensor; 0 for horizontal ranges
  double range = 0;                      ///< [m]
};

/// All ranges of one time.
using RadioEpoch = std::vector<RadioRange>;

struct RangeBiases
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<double> sensor;         ///< [m] measured minus true range, by sensor
  std::vector<double> landmark;       ///< [m] on top of it, by landmark; their sum is zero
  std::vector<double> std_sensor;     ///< [m] as if the ranges' errors were independent
  std::vector<double> std_landmark;   ///< likewise
  std::vector<double> outlier_share;  ///< by landmark: ranges further than four scatters from the fit
  double scatter = 0;                 ///< [m] of the ranges about the fit: 1.48 times the median absolute residual
  std::size_t epochs = 0;             ///< that were used
};

/// Range biases of the radios (their antenna delays, as lengths) from the ranges alone. All poses and all biases are
/// adjusted together: least squares with a Cauchy loss of scale 2 `std_range`, poses eliminated by the Schur
/// complement. The biases are observable because a wrong one pulls the poses at different positions into different
/// directions. No motion is assumed between epochs. Each epoch needs four ranges or more, with two sensors or more, and
/// starts at its own best pose. Status: `too_few` below ten such epochs; `degenerate` when some bias stays
/// undetermined; `bad_input`. Biases that are hardly observable (a robot that never moved) have large standard
/// deviations.
[[nodiscard]] RangeBiases estimateRangeBiases(const std::vector<RadioEpoch>& epochs, double std_range);
}  // namespace mrpt_ext
