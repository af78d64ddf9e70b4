#include "mrpt_ext/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
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
