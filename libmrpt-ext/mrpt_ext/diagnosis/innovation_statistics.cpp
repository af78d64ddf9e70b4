#include "mrpt_ext/diagnosis/innovation_statistics.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
void InnovationStatistics::add(double value)
{
  const double size = std::min(std::abs(value), kLargest - kBin / 2);
  ++histogram_[static_cast<std::size_t>(size / kBin)];
  ++count_;
}

double InnovationStatistics::scatter() const
{
  double below = 0;
  for (std::size_t k = 0; k < histogram_.size() && count_ > 0; ++k)
  {
    if (below + histogram_[k] >= count_ / 2)
      return (static_cast<double>(k) + (count_ / 2 - below) / histogram_[k]) * kBin / kNormalMedianDeviation;
    below += histogram_[k];
  }
  return 1;
}

void OutlierStatistics::add(bool outlier)
{
  const Block item{1, outlier ? 1.0 : 0.0};
  all_ += item;
  blocks_.open() += item;
  blocks_.endItem();
}

double OutlierStatistics::shareStd() const
{
  constexpr std::size_t kLeastBlocksOfShare = 8;
  const std::vector<Block>& blocks = blocks_.complete();
  if (blocks.size() < kLeastBlocksOfShare) return 1;
  double squares = 0, count = 0;
  for (const Block& block : blocks)
  {
    const double excess = block.outliers - share() * block.count;
    squares += excess * excess;
    count += block.count;
  }
  return std::sqrt(squares) / count;
}
}  // namespace mrpt_ext
