#include "mrpt_ext/correspondence/bearings/direction_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kWidestGate = 0.5;  // [rad] beyond this a landmark may match any bearing
constexpr int kMinBins = 512, kMaxBins = 8192;
constexpr std::size_t kCategories = 256;

/// Pseudo-angle in [0, 4).
double pseudoAngle(double angle)
{
  const double x = std::cos(angle), y = std::sin(angle);
  const double p = y / (std::abs(x) + std::abs(y));
  return x < 0 ? 3 - p : 1 + p;
}

/// Upper end of the variance ratios of a step.
double ratioAbove(int step)
{
  constexpr int kSteps = 1 << DirectionTable::kStepBits;
  return std::ldexp(1 + static_cast<double>((step & (kSteps - 1)) + 1) / kSteps, step >> DirectionTable::kStepBits);
}
}  // namespace

DirectionTable::DirectionTable(std::span<const ScanBearing> bearings, double gate)
    : size_(static_cast<int>(std::min(bearings.size(), kMaxBearings))),
      of_category_(kCategories, 0),
      from_category_(kCategories, 0),
      bearings_(bearings.begin(), bearings.end())
{
  double widest = 0;
  for (const ScanBearing& r : bearings) widest = std::max(widest, r.std);
  if (!(widest > 0)) return;
  inverse_variance_ = static_cast<float>(1 / square(widest));
  const double narrow = gate * widest;
  bins_ =
      static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(8 / narrow, 1.0 * kMinBins, 1.0 * kMaxBins))));
  levels_ = 1;
  while (narrow * std::sqrt(ratioAbove(levels_ - 1)) < kWidestGate) ++levels_;
  sets_.assign(static_cast<std::size_t>(levels_) * static_cast<std::size_t>(bins_), 0);
  for (int i = 0; i < size_; ++i)
  {
    const ScanBearing& bearing = bearings[static_cast<std::size_t>(i)];
    const std::uint32_t bit = 1U << i;
    for (std::size_t category = 0; category < kCategories; ++category)
      if (bearing.category == kAnyCategory || (static_cast<std::size_t>(bearing.category) % kCategories) == category)
        of_category_[category] |= bit;
    has_categories_ = has_categories_ || bearing.category != kAnyCategory;
    for (int level = 0; level < levels_; ++level)
    {
      const double excess = (ratioAbove(level) - 1) * square(widest);
      const double half_width = level + 1 == levels_ ? kPi : gate * std::sqrt(square(bearing.std) + excess);
      addBearing(bit, bearing.angle, half_width,
                 sets_.data() + static_cast<std::size_t>(level) * static_cast<std::size_t>(bins_));
    }
  }
  from_category_ = of_category_;
  for (std::size_t category = kCategories - 1; category-- > 0;)
    from_category_[category] |= from_category_[category + 1];
}

void DirectionTable::addBearing(std::uint32_t bit, double bearing, double half_width, std::uint32_t* level) const
{
  const auto bin_of = [&](double angle) { return static_cast<int>(pseudoAngle(angle) * bins_ / 4); };
  const double rounding = 1e-5;  // of the float arithmetic that looks up
  int first = 0, count = bins_;
  if (half_width + rounding < kPi / 2)
  {
    first = bin_of(bearing - half_width - rounding) & (bins_ - 1);
    count = ((bin_of(bearing + half_width + rounding) - first) & (bins_ - 1)) + 1;
  }
  const auto add = [&](int begin, int end)
  {
    for (int b = begin; b < end; ++b) level[b] |= bit;
  };
  add(first, std::min(first + count, bins_));
  add(0, first + count - bins_);
}
}  // namespace mrpt_ext
