#include "mrpt_ext/correspondence/bearings/visibility_grid.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/correspondence/bearings/direction_intervals.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMaxGridCells = 400'000;
constexpr float kCloseHalfWidth = 0.6F;  // [rad] about two radii from the middle of the cell
constexpr int kSamples = 16;             // per side, to learn how far landmarks are

/// Mean over positions of the sum over landmarks of 1 / distance, and mean number of landmarks in range.
struct Surroundings
{
  double in_range = 0, inverse_distance = 0;
};

Surroundings surroundingsOf(const LandmarkIndex& map, const Box2& area, double max_range, double nearest)
{
  Surroundings mean;
  const Vector2d step = (area.max - area.min) / kSamples;
  for (int n = 0; n < kSamples * kSamples; ++n)
  {
    const int column = n % kSamples, row = n / kSamples;
    const Vector2d point(area.min.x() + (column + 0.5) * step.x(), area.min.y() + (row + 0.5) * step.y());
    for (const Vector2d& landmark : map.positions())
    {
      const double distance = (landmark - point).norm();
      if (distance > max_range) continue;
      mean.in_range += 1.0 / (kSamples * kSamples);
      mean.inverse_distance += 1.0 / (kSamples * kSamples) / std::max(distance, nearest);
    }
  }
  return mean;
}
}  // namespace

std::optional<VisibilityGrid::Layout> VisibilityGrid::chooseLayout(const LandmarkIndex& map, const Box2& area,
                                                                   double max_range, double motion)
{
  const Vector2d extent = area.max - area.min;
  if (map.empty() || !extent.allFinite() || !(extent.minCoeff() > 0)) return std::nullopt;
  Layout layout{area, max_range};
  const double largest = extent.maxCoeff();
  const Surroundings around = surroundingsOf(map, area, max_range, 1e-3 * largest);
  if (!(around.in_range > 0)) return std::nullopt;
  const double typical_distance = around.in_range / around.inverse_distance;
  layout.cell = std::sqrt(2.0) * motion * kBinWidth * typical_distance;
  if ((extent / layout.cell).array().ceil().prod() > kMaxGridCells) return std::nullopt;
  layout.columns = static_cast<int>(std::ceil(extent.x() / layout.cell));
  layout.rows = static_cast<int>(std::ceil(extent.y() / layout.cell));
  const double bins_set =
      around.in_range * kReach + 2 * layout.cell * std::sqrt(0.5) * around.inverse_distance / kBinWidth;
  layout.occupancy = 1 - std::exp(-bins_set / kBins);
  return layout;
}

VisibilityGrid::VisibilityGrid(const LandmarkIndex& map, const Layout& layout)
    : layout_(layout), bits_(layout.cells() * kWords), close_(layout.cells())
{
  DirectionIntervals seen(map.positions(), (layout.area.min + layout.area.max) / 2);
  const double farthest = std::min(layout.max_range, 1e9) + cellRadius();
  for (std::size_t c = 0; c < layout.cells(); ++c)
  {
    seen.update(centre(c), cellRadius(), farthest);
    fillRing(seen.direction(), seen.halfWidth(), c);
  }
}

Vector2d VisibilityGrid::centre(std::size_t cell) const
{
  const auto columns = static_cast<std::size_t>(layout_.columns);
  const std::size_t column = cell % columns, row = cell / columns;
  return layout_.area.min + layout_.cell * Vector2d(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

void VisibilityGrid::fillRing(const std::vector<float>& direction, const std::vector<float>& half_width,
                              std::size_t cell)
{
  std::uint64_t* ring = bits_.data() + cell * kWords;
  constexpr auto kPerRadian = static_cast<float>(1 / kBinWidth);
  constexpr float kRounding = 0.01F;  // [bins] of the directions' float arithmetic
  for (std::size_t l = 0; l < direction.size(); ++l)
  {
    if (half_width[l] < 0) continue;  // out of range
    if (half_width[l] > kCloseHalfWidth)
    {
      close_[cell] = static_cast<std::uint8_t>(std::min(255, close_[cell] + 1));
      continue;
    }
    const float middle = direction[l] * kPerRadian, half = half_width[l] * kPerRadian + kRounding;
    const int count = std::min(
        kBins, static_cast<int>(std::floor(middle + half)) - static_cast<int>(std::floor(middle - half)) + kReach);
    const int first = static_cast<int>(std::floor(middle - half)) - (kReach - 1) + 2 * kBins;
    for (int q = first; q < first + count;)
    {
      const int bit = q & 63, here = std::min(64 - bit, first + count - q);
      const std::uint64_t ones = here == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << here) - 1;
      ring[(q & (kBins - 1)) >> 6] |= ones << bit;
      q += here;
    }
  }
}
}  // namespace mrpt_ext
