#pragma once

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
/// Logarithm of n over k.
[[nodiscard]] inline double logChoose(int n, int k)
{
  return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

/// Probability that at least `least` of n hit, each with chance p.
[[nodiscard]] inline double binomialTail(int n, int least, double p)
{
  if (least <= 0) return 1;
  if (p <= 0) return 0;
  if (p >= 1) return least <= n ? 1 : 0;
  double tail = 0;
  for (int k = least; k <= n; ++k) tail += std::exp(logChoose(n, k) + k * std::log(p) + (n - k) * std::log1p(-p));
  return std::min(tail, 1.0);
}
}  // namespace mrpt_ext
