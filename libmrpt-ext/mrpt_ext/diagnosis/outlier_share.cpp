#include "mrpt_ext/diagnosis/outlier_share.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kTimeBlocks = 20;
constexpr double kExcess = 4;  // standard deviations of the count in a block

struct Count
{
  double readings = 0, matched = 0, outliers = 0;
};

/// By block of poses.
std::vector<Count> countsOf(const CalibrationData& data, const std::vector<double>& misfits, std::size_t sensor,
                            bool is_range, std::size_t end)
{
  const std::size_t poses = std::min(end, data.problem.poses.size());
  std::vector<Count> counts(kTimeBlocks);
  const auto add = [&](std::size_t pose, bool is_matched, bool is_outlier)
  {
    Count& count = counts[pose * kTimeBlocks / poses];
    ++count.readings;
    count.matched += is_matched;
    count.outliers += is_outlier;
  };
  for (std::size_t i = 0; i < std::min(misfits.size(), data.problem.readings.size()); ++i)
    if (const CalibrationReading& r = data.problem.readings[i];
        r.pose < poses && r.sensor == sensor && r.is_range == is_range)
      add(r.pose, true, std::abs(misfits[i]) > kOutlierMisfit);
  for (const UnmatchedReading& r : data.unmatched)
    if (r.pose < poses && r.sensor == sensor && r.is_range == is_range) add(r.pose, false, true);
  std::erase_if(counts, [](const Count& count) { return count.readings == 0; });
  return counts;
}

OutlierShare shareOf(const CalibrationData& data, const std::vector<double>& misfits, std::size_t sensor, bool is_range,
                     std::size_t end)
{
  const std::vector<Count> counts = countsOf(data, misfits, sensor, is_range, end);
  if (counts.empty()) return {};
  std::vector<double> shares;
  for (const Count& count : counts) shares.push_back(count.outliers / count.readings);
  const double typical = upperMedian(shares);
  Count all;
  for (const Count& count : counts)
  {
    const double expected = std::max(1.0, typical * count.readings);
    if (count.outliers > expected + kExcess * std::sqrt(expected)) continue;
    all.readings += count.readings;
    all.matched += count.matched;
    all.outliers += count.outliers;
  }
  if (all.matched == 0) return {};
  const double share = all.outliers / all.readings;
  return {.readings = static_cast<std::size_t>(all.readings),
          .matched = static_cast<std::size_t>(all.matched),
          .share = share,
          .std = std::sqrt(share * (1 - share) / all.readings)};
}
}  // namespace

OutlierShare outlierShare(const CalibrationData& data, const std::vector<double>& misfits, std::size_t sensor,
                          std::size_t end)
{
  const OutlierShare bearings = shareOf(data, misfits, sensor, false, end);
  const OutlierShare ranges = shareOf(data, misfits, sensor, true, end);
  return ranges.readings == 0 || bearings.share > ranges.share ? bearings : ranges;
}
}  // namespace mrpt_ext
