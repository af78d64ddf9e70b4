#pragma once

#include <Eigen/Cholesky>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::papers
{
/// A position error [m] of an estimator that reaches this bound: drawn, so that means and medians of distances can be
/// compared, which the bound itself does not speak of.
[[nodiscard]] inline double errorAtBound(const Matrix2d& covariance, RandomStream& random)
{
  const Vector2d unit(random.gaussian(), random.gaussian());
  return Vector2d(covariance.llt().matrixL() * unit).norm();
}
}  // namespace mrpt_ext::papers
