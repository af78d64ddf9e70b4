#include "mrpt_ext/correspondence/bearings/bearing_search_tables.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kRangeMargin = 0.02;  // of the range limit
constexpr std::size_t kKeptGrids = 2;  // areas that change from search to search must not fill the memory
}  // namespace

std::shared_ptr<const PotentiallyVisibleSets> BearingSearchTables::visibleSets(double max_range) const
{
  const std::scoped_lock lock(mutex_);
  for (const auto& sets : visible_sets_)
    if (sets->maxRange() == max_range) return sets;
  const double margin = std::isfinite(max_range) ? kRangeMargin * max_range : 0;
  return visible_sets_.emplace_back(std::make_shared<const PotentiallyVisibleSets>(map_, max_range, margin));
}

std::shared_ptr<const NeighbourGrid> BearingSearchTables::neighboursOf(int category) const
{
  const std::scoped_lock lock(mutex_);
  auto& grid = neighbours_[category];
  if (!grid) grid = std::make_shared<const NeighbourGrid>(map_, category);
  return grid;
}

std::shared_ptr<const VisibilityGrid> BearingSearchTables::visibilityGrid(const VisibilityGrid::Layout& layout) const
{
  const std::scoped_lock lock(mutex_);
  for (const auto& grid : grids_)
    if (grid->isOf(layout.area, layout.max_range) && grid->layout().cell == layout.cell) return grid;
  if (grids_.size() == kKeptGrids) grids_.erase(grids_.begin());
  return grids_.emplace_back(std::make_shared<const VisibilityGrid>(map_, layout));
}

std::shared_ptr<const VisibilityGrid> BearingSearchTables::builtVisibilityGrid(const Box2& area, double max_range) const
{
  const std::scoped_lock lock(mutex_);
  const auto found =
      std::find_if(grids_.begin(), grids_.end(), [&](const auto& grid) { return grid->isOf(area, max_range); });
  return found == grids_.end() ? nullptr : *found;
}
}  // namespace mrpt_ext
