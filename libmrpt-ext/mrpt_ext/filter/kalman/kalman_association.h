#pragma once

#include <span>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"

namespace mrpt_ext
{
/// A detection against all landmarks it may show, and against clutter.
struct Association
{
  double evidence = 0;            ///< p(z)
  double inlier_probability = 0;  ///< share of it that the landmarks have
  double best = 0;                ///< share of the likeliest landmark
  std::size_t landmark = 0;       ///< the likeliest, where best > 0
  double nis = 0;                 ///< normalised innovation squared to it
  DetectionRows rows;             ///< to it
};

/// Terms of the mixture that kalman_update.h describes. `default_max_range` [m] is used for a sensor that
/// declares none.
[[nodiscard]] Association associate(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                                    const KalmanState& state, const BiasModel& biases, double default_max_range);

/// The rows that are in use.
[[nodiscard]] inline std::span<const KalmanRow> rowsOf(const DetectionRows& detection)
{
  return {detection.rows.data(), static_cast<std::size_t>(detection.count)};
}
}  // namespace mrpt_ext
