#include "mrpt_ext/vision/light_coding.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kCodingPower = 2.2;
constexpr double kBrightestLevel = 255;
constexpr double kUsualBrightness = 1.05;  ///< of a side that is too bright, share of the brightest level
constexpr int kQuantileRounds = 20;        ///< of bisection
constexpr double kEqualLevels = 0.98;      ///< ratio from which on there is no shift to speak of

double standardNormal(double z) { return std::exp(-z * z / 2) / std::sqrt(kTwoPi); }

double normalQuantile(double share)
{
  double low = -8, high = 8;
  for (int round = 0; round < kQuantileRounds; ++round)
  {
    const double middle = (low + high) / 2;
    (std::erfc(-middle / std::sqrt(2.0)) / 2 < share ? low : high) = middle;
  }
  return low;
}
}  // namespace

double shiftByCoding(double level, double other)
{
  const double bright = std::max(level, other);
  const double ratio = std::max(0.0, std::min(level, other)) / bright;
  if (!(bright > 0) || ratio > kEqualLevels) return 0;
  // Mean coded level of pixels of which the bright side covers a share between none and all.
  const double light = std::pow(ratio, kCodingPower);
  const double mean = (1 - std::pow(light, 1 + 1 / kCodingPower)) / ((1 + 1 / kCodingPower) * (1 - light));
  return (mean - ratio) / (1 - ratio) - 0.5;
}

double shiftByClipping(double dark_level)
{
  const double shown = std::max(1.0, kBrightestLevel - dark_level);
  const double share = shown / (kUsualBrightness * kBrightestLevel - kBrightestLevel + shown);
  return standardNormal(normalQuantile(share)) / share;
}
}  // namespace mrpt_ext
