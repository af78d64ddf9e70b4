#pragma once

#include <cstdint>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"

namespace mrpt_ext
{
/// For every cell of a grid over the map, the landmarks that a sensor with this range limit can see from somewhere
/// in the cell, as arrays ready for vector instructions. Coordinates are relative to the centre of the cell, so
/// that a large map costs no digits. Without a range limit there is one cell with all landmarks. Built in O(cells *
/// landmarks in view); cells grow until the sets take about 100 MB at most.
class PotentiallyVisibleSets
{
 public:
  static constexpr std::size_t kBlock = 16;  ///< visible_sets are padded to multiples of this

  /// `max_range` [m], infinity for none; `margin` [m]: how far beyond it landmarks are listed.
  PotentiallyVisibleSets(const LandmarkIndex& map, double max_range, double margin);

  struct Cell
  {
    const float* x;  ///< [m] relative to the centre; padding is far away
    const float* y;
    const std::uint8_t*
        category;       ///< ascending; categories beyond 255 share numbers: a category never excludes its own landmarks
    std::size_t count;  ///< with padding
  };

  [[nodiscard]] double maxRange() const { return max_range_; }
  [[nodiscard]] double cellSize() const { return cell_; }
  [[nodiscard]] const Vector2d& origin() const { return origin_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double meanCount() const { return mean_count_; }  ///< landmarks per list, without padding
  /// All landmarks, so that those next to each other in the map are next to each other here.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] std::size_t bytes() const;

  struct CellAt
  {
    Cell cell;
    Vector2d centre;
  };
  /// The cell around a point of the world; outside the grid the nearest.
  [[nodiscard]] CellAt cellAt(const Vector2d& point) const;

  /// `index` = row * columns() + column.
  [[nodiscard]] Cell cell(std::size_t index) const
  {
    const std::size_t first = first_[index];
    return {x_.data() + first, y_.data() + first, category_.data() + first, first_[index + 1] - first};
  }

 private:
  void chooseGrid(const LandmarkIndex& map);
  void fill(const LandmarkIndex& map);
  void orderByTiles(const LandmarkIndex& map);

  double max_range_, margin_;
  double cell_ = 1;
  Vector2d origin_{0, 0};
  int columns_ = 1, rows_ = 1;
  double mean_count_ = 0;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> order_;
  std::vector<float> x_, y_;
  std::vector<std::uint8_t> category_;
};
}  // namespace mrpt_ext
