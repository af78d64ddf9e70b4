#pragma once

#include <span>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"

namespace mrpt_ext
{
/// One or two rows as a state predicts them.
struct Innovation
{
  double log_density = 0;  ///< of N(residual; 0, H P H^T + R)
  double nis = 0;          ///< normalised innovation squared
};

/// Density of the residuals of `rows` (one or two) under the state's covariance; always finite.
[[nodiscard]] Innovation innovationOf(std::span<const KalmanRow> rows, const KalmanMatrix& covariance);

/// Applies independent rows one after the other, all linearised at the same mean: gain K, mean + K residual, and
/// Joseph's form (I - K H) P (I - K H)^T + K R K^T. A row without information changes nothing.
void applyRows(std::span<const KalmanRow> rows, KalmanState& state);
}  // namespace mrpt_ext
