#pragma once

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// Loss for a residual of `e2` squared standard deviations: its square up to 2.5 standard deviations, then that of
/// Geman and McClure for what exceeds it, bounded, so that outliers hardly count. Gaussian residuals are nearly all in
/// the quadratic part: there weights, information and redundancy are those of least squares. (Geman and McClure's own
/// loss weighs them by 0.9 on average, and what poses take of a residual is then predicted too small by a fifth.)
namespace robust
{
inline constexpr double kScale2 = 16;       // squared standard deviations of an excess that counts for a quarter
inline constexpr double kCore = 6.25 / 16;  // quadratic up to this share of the scale

/// Of `e2` beyond the quadratic part, over the scale.
[[nodiscard]] inline double excess(double e2, double scale2) { return std::max(e2 / scale2 - kCore, 0.0); }

[[nodiscard]] inline double loss(double e2, double scale2 = kScale2)
{
  const double u = excess(e2, scale2);
  return e2 - scale2 * u + scale2 * u / (1 + u);
}
/// Weight in the normal equations: d loss / d e2.
[[nodiscard]] inline double weight(double e2, double scale2 = kScale2) { return 1 / square(1 + excess(e2, scale2)); }
/// Second derivative of half the loss: what a residual really adds to the information.
[[nodiscard]] inline double curvature(double e2)
{
  const double u = excess(e2, kScale2);
  return u > 0 ? (1 + u - 4 * e2 / kScale2) / (square(1 + u) * (1 + u)) : 1;
}

/// Likelihood of a residual that is Gaussian or that of an outlier, which is as likely everywhere: minus twice its
/// logarithm, above that of no residual.
class Mixture
{
 public:
  /// `outlier`: density of an outlier over that of a Gaussian residual of zero, times the odds of being one.
  explicit Mixture(double outlier) : outlier_(outlier) {}

  [[nodiscard]] double loss(double e2) const { return -2 * std::log((std::exp(-e2 / 2) + outlier_) / (1 + outlier_)); }
  /// Probability of being no outlier: d loss / d e2.
  [[nodiscard]] double weight(double e2) const { return 1 / (1 + outlier_ * std::exp(e2 / 2)); }
  /// Second derivative of half the loss.
  [[nodiscard]] double curvature(double e2) const
  {
    const double inlier = weight(e2);
    return inlier > 0 ? inlier * (1 - (1 - inlier) * e2) : 0;
  }

 private:
  double outlier_;
};
}  // namespace robust
}  // namespace mrpt_ext
