#pragma once

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// Loss of Geman and McClure for a residual of `e2` squared standard deviations: as e2 near zero, at most c^2, so that
/// outliers do not count at all. Efficiency 0.97 for Gaussian residuals.
namespace robust
{
inline constexpr double kScale2 = 16;  // c^2: four standard deviations

[[nodiscard]] inline double loss(double e2, double scale2 = kScale2) { return e2 / (1 + e2 / scale2); }
/// Weight in the normal equations: d loss / d e2.
[[nodiscard]] inline double weight(double e2, double scale2 = kScale2) { return 1 / square(1 + e2 / scale2); }
/// Second derivative of half the loss: what a residual really adds to the information.
[[nodiscard]] inline double curvature(double e2)
{
  const double u = e2 / kScale2;
  return (1 - 3 * u) / (square(1 + u) * (1 + u));
}
}  // namespace robust
}  // namespace mrpt_ext
