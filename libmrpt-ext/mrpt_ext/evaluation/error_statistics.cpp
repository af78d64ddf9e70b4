#include "mrpt_ext/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
double quantileOfSorted(const std::vector<double>& sorted, double probability)
{
  const double position = std::clamp(probability, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}
}  // namespace

std::optional<double> quantile(std::vector<double> sample, double probability)
{
  if (sample.empty()) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  return quantileOfSorted(sample, probability);
}

ErrorStatistics errorStatistics(std::vector<double> sample)
{
  ErrorStatistics statistics;
  statistics.count = sample.size();
  if (sample.empty()) return statistics;

  std::sort(sample.begin(), sample.end());
  const auto n = static_cast<double>(sample.size());
  double sum = 0, sum_of_squares = 0;
  for (const double error : sample)
  {
    sum += error;
    sum_of_squares += error * error;
  }
  const double mean = sum / n;
  double spread = 0;
  for (const double error : sample) spread += (error - mean) * (error - mean);

  statistics.rmse = std::sqrt(sum_of_squares / n);
  statistics.mean = mean;
  statistics.median = quantileOfSorted(sample, 0.5);
  statistics.std = std::sqrt(spread / n);
  statistics.min = sample.front();
  statistics.max = sample.back();
  statistics.p95 = quantileOfSorted(sample, 0.95);
  return statistics;
}
}  // namespace mrpt_ext
