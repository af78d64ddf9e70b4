#include "mrpt_ext/calibration/outlier_model.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/calibration/robust_loss.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLeastOutliers = 1e-3, kMostOutliers = 0.5;  // shares
}  // namespace

std::vector<double> longestRanges(const CalibrationProblem& problem)
{
  std::vector<double> longest(problem.sensors, 1);
  for (const CalibrationReading& r : problem.readings)
    if (r.is_range) longest[r.sensor] = std::max(longest[r.sensor], r.value);
  return longest;
}

void OutlierModel::tell(const CalibrationProblem& problem)
{
  by_sensor_.clear();
  for (const double longest : longestRanges(problem)) by_sensor_.push_back({.ranges = {.span = longest}});
}

ReadingLoss OutlierModel::lossOf(const CalibrationReading& r, double e2, double scatter) const
{
  if (!told()) return {robust::loss(e2), robust::weight(e2), robust::curvature(e2)};
  const auto& [share, span] = r.is_range ? by_sensor_[r.sensor].ranges : by_sensor_[r.sensor].bearings;
  const robust::Mixture mixture(share / (1 - share) * std::sqrt(kTwoPi) * r.std * scatter / span);
  return {mixture.loss(e2), mixture.weight(e2), mixture.curvature(e2)};
}

void OutlierModel::estimateShares(const CalibrationProblem& problem, const std::vector<double>& weights)
{
  struct Sum
  {
    double outliers = 0, all = 0;
    [[nodiscard]] double share() const
    {
      return std::clamp(outliers / std::max(all, 1.0), kLeastOutliers, kMostOutliers);
    }
  };
  std::vector<Sum> bearings(problem.sensors), ranges(problem.sensors);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const CalibrationReading& r = problem.readings[i];
    Sum& sum = (r.is_range ? ranges : bearings)[r.sensor];
    sum.outliers += 1 - weights[i];
    ++sum.all;
  }
  for (std::size_t s = 0; s < problem.sensors; ++s)
  {
    by_sensor_[s].bearings.share = bearings[s].share();
    by_sensor_[s].ranges.share = ranges[s].share();
  }
}
}  // namespace mrpt_ext
