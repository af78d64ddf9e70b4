#include "mrpt_ext/experiment/detection_reach.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kBinsPerOctave = 8;
constexpr double kQuantile = 0.99;
constexpr double kDiagonals = 3;      // of the map
constexpr double kLeastRange = 1e-3;  // [m]

int binOf(double range)
{
  return static_cast<int>(std::ceil(kBinsPerOctave * std::log2(std::max(range, kLeastRange))));
}
}  // namespace

void DetectionReach::add(const Reading& reading)
{
  for (const Detection& detection : reading.detections)
  {
    if (detection.id == kNoId)
      anonymous_ = true;
    else if (detection.range)
    {
      ++ranges_[binOf(*detection.range)];
      ++count_;
    }
    else if (reading.model.max_range)
      farthest_bearing_ = std::max(farthest_bearing_, *reading.model.max_range);
    else
      unlimited_ = true;
  }
}

double DetectionReach::rangeQuantile() const
{
  std::size_t below = 0;
  for (const auto& [bin, count] : ranges_)
  {
    below += count;
    if (static_cast<double>(below) >= kQuantile * static_cast<double>(count_)) return std::exp2(bin / kBinsPerOctave);
  }
  return 0;
}

std::optional<double> DetectionReach::metres(double map_diagonal) const
{
  const double reach = std::max({rangeQuantile(), farthest_bearing_, unlimited_ ? kDiagonals * map_diagonal : 0});
  return anonymous_ || !(reach > 0) ? std::nullopt : std::optional(reach);
}
}  // namespace mrpt_ext
