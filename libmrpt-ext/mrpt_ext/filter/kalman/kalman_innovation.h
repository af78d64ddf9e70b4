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

/// A step of the state from where it is, with its covariance.
struct StepPosterior
{
  KalmanVector step;
  KalmanMatrix covariance;
};

/// The posterior of a step whose prior has this covariance and mean zero. Independent rows are applied one after the
/// other, all linearised where the step begins: gain K, step + K residual, and Joseph's form
/// (I - K H) P (I - K H)^T + K R K^T. A row without information changes nothing.
[[nodiscard]] StepPosterior posteriorStep(std::span<const KalmanRow> rows, const KalmanMatrix& prior);

/// The state moved by posteriorStep() (rigid_step.h).
void applyRows(std::span<const KalmanRow> rows, KalmanState& state);
}  // namespace mrpt_ext
