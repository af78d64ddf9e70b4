#include "mrpt_ext/correspondence/bearings/potentially_visible_sets.h"

#include <algorithm>
#include <numeric>

namespace mrpt_ext
{
namespace
{
constexpr double kCellsPerRange = 8;
constexpr double kGrowth = 1.25;
constexpr double kMaxBytes = 100e6;
constexpr double kBytesPerEntry = 2 * sizeof(float) + sizeof(std::uint8_t);
constexpr double kMaxCells = 4e6;
constexpr float kFarAway = 1e9F;

std::uint8_t listedCategory(const LandmarkIndex& map, std::size_t landmark)
{
  return static_cast<std::uint8_t>(map.category(landmark));
}
}  // namespace

PotentiallyVisibleSets::PotentiallyVisibleSets(const LandmarkIndex& map, double max_range, double margin)
    : max_range_(max_range), margin_(margin)
{
  chooseGrid(map);
  fill(map);
  orderByTiles(map);
}

void PotentiallyVisibleSets::chooseGrid(const LandmarkIndex& map)
{
  const Vector2d extent = map.high() - map.low();
  if (!std::isfinite(max_range_))
  {
    cell_ = std::max(1.0, 2 * extent.maxCoeff());
    origin_ = 0.5 * (map.low() + map.high()) - Vector2d::Constant(0.5 * cell_);
    return;
  }
  const double reach = max_range_ + margin_;
  origin_ = map.low() - Vector2d::Constant(reach);
  const Vector2d span = extent + Vector2d::Constant(2 * reach);
  const double density = static_cast<double>(map.size()) / (extent + Vector2d::Constant(reach)).prod();
  const auto too_large = [&]
  {
    const double cells = span.prod() / square(cell_);
    const double per_cell = density * kPi * square(reach + 0.71 * cell_) + 0.5 * static_cast<double>(kBlock);
    return cells > kMaxCells || cells * (per_cell * kBytesPerEntry + sizeof(std::size_t)) > kMaxBytes;
  };
  cell_ = max_range_ / kCellsPerRange;
  while (too_large()) cell_ *= kGrowth;
  columns_ = static_cast<int>(span.x() / cell_) + 1;
  rows_ = static_cast<int>(span.y() / cell_) + 1;
}

void PotentiallyVisibleSets::fill(const LandmarkIndex& map)
{
  const bool limited = std::isfinite(max_range_);
  const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  first_.reserve(cells + 1);
  first_.push_back(0);
  std::size_t listed = 0;
  std::vector<std::size_t> near;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column)
    {
      const Vector2d centre = origin_ + cell_ * Vector2d(column + 0.5, row + 0.5);
      const double radius = limited ? max_range_ + margin_ + 0.7072 * cell_ : 2 * cell_;
      near.clear();
      map.forEachNear(centre, radius, [&](std::size_t l) { near.push_back(l); });
      if (map.categoryCount() > 1)
        std::stable_sort(near.begin(), near.end(),
                         [&](std::size_t a, std::size_t b) { return listedCategory(map, a) < listedCategory(map, b); });
      for (const std::size_t l : near)
      {
        const Vector2d d = map.position(l) - centre;
        x_.push_back(static_cast<float>(d.x()));
        y_.push_back(static_cast<float>(d.y()));
        category_.push_back(listedCategory(map, l));
      }
      listed += near.size();
      const std::size_t padded = (x_.size() + kBlock - 1) / kBlock * kBlock;
      x_.resize(padded, kFarAway);
      y_.resize(padded, kFarAway);
      category_.resize(padded, 0);
      first_.push_back(padded);
    }
  mean_count_ = static_cast<double>(listed) / static_cast<double>(cells);
}

void PotentiallyVisibleSets::orderByTiles(const LandmarkIndex& map)
{
  order_.resize(map.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!std::isfinite(max_range_)) return;
  const double tile = 2 * max_range_;
  const auto tile_of = [&](std::uint32_t l)
  {
    const Vector2d p = (map.position(l) - map.low()) / tile;
    return std::pair(std::floor(p.y()), std::floor(p.x()));
  };
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return tile_of(a) < tile_of(b); });
}

PotentiallyVisibleSets::CellAt PotentiallyVisibleSets::cellAt(const Vector2d& point) const
{
  const auto along = [this](double offset, int count)
  { return static_cast<int>(std::clamp(std::floor(offset / cell_), 0.0, count - 1.0)); };
  const int column = along(point.x() - origin_.x(), columns_), row = along(point.y() - origin_.y(), rows_);
  return {cell(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)),
          origin_ + cell_ * Vector2d(column + 0.5, row + 0.5)};
}

std::size_t PotentiallyVisibleSets::bytes() const
{
  return x_.size() * 2 * sizeof(float) + category_.size() + first_.size() * sizeof(std::size_t) +
         order_.size() * sizeof(std::uint32_t);
}
}  // namespace mrpt_ext
