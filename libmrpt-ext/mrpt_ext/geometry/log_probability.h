#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
inline constexpr double kLogZero = -std::numeric_limits<double>::infinity();

/// log(exp(a) + exp(b)) without overflow; either may be minus infinity.
[[nodiscard]] inline double logSum(double a, double b)
{
  const double high = std::max(a, b);
  return std::isfinite(high) ? high + std::log1p(std::exp(std::min(a, b) - high)) : high;
}

/// Logarithm of the normal density N(residual; 0, variance).
[[nodiscard]] inline double logNormal(double residual, double variance)
{
  return -0.5 * (residual * residual / variance + std::log(kTwoPi * variance));
}
}  // namespace mrpt_ext
