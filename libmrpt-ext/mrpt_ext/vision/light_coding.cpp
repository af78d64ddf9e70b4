#include "mrpt_ext/vision/light_coding.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kCodingPower = 2.2;
constexpr double kBrightestLevel = 255;
constexpr double kUsualBrightness = 1.05;  ///< of a side that is too bright, share of the brightest level
constexpr double kEqualLevels = 0.98;      ///< ratio from which on there is no shift to speak of
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
  const boost::math::normal blur;
  return boost::math::pdf(blur, boost::math::quantile(blur, share)) / share;
}
}  // namespace mrpt_ext
