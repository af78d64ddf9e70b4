#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "mrpt_ext/correspondence/bearings/neighbour_grid.h"
#include "mrpt_ext/correspondence/bearings/potentially_visible_sets.h"
#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/landmark_index.h"

namespace mrpt_ext
{
/// What a search by bearings precomputes from the map: each table is built when it is first asked for, then kept. Safe
/// to share between threads.
class BearingSearchTables
{
 public:
  /// The map must outlive the tables.
  explicit BearingSearchTables(const LandmarkIndex& map) : map_(map) {}

  /// The landmarks in view from every cell, for this range limit [m] (infinity: none).
  [[nodiscard]] std::shared_ptr<const PotentiallyVisibleSets> visibleSets(double max_range) const;
  /// The landmarks of a category (kAnyCategory: all) in buckets.
  [[nodiscard]] std::shared_ptr<const NeighbourGrid> neighboursOf(int category) const;
  [[nodiscard]] std::shared_ptr<const VisibilityGrid> visibilityGrid(const VisibilityGrid::Layout& layout) const;
  /// The grid that already exists for this area and range limit, or null.
  [[nodiscard]] std::shared_ptr<const VisibilityGrid> builtVisibilityGrid(const Box2& area, double max_range) const;

 private:
  const LandmarkIndex& map_;
  mutable std::mutex mutex_;
  mutable std::vector<std::shared_ptr<const PotentiallyVisibleSets>> visible_sets_;
  mutable std::map<int, std::shared_ptr<const NeighbourGrid>> neighbours_;  // by category
  mutable std::vector<std::shared_ptr<const VisibilityGrid>> grids_;
};
}  // namespace mrpt_ext
