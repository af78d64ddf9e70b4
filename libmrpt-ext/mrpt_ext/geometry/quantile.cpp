#include "mrpt_ext/geometry/quantile.h"

#include <algorithm>
#include <utility>

namespace mrpt_ext
{
double quantileOfSorted(const std::vector<double>& sorted, double probability)
{
  const double position = std::clamp(probability, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::optional<double> quantile(std::vector<double> sample, double probability)
{
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  return quantileOfSorted(sample, probability);
}

std::optional<double> median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }
}  // namespace mrpt_ext
