#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/geometry/box.h"

namespace mrpt_ext
{
/// Directions of visible landmarks from everywhere in an area: for each cell of a grid a ring of bits, one per
/// world direction, set where a landmark may be seen from some point of the cell. Built once per map, area and
/// range limit in O(cells * landmarks); 256 bytes per cell.
///
/// A landmark in a cell or close to it may be seen in any direction. It is left out of the ring and counted
/// instead.
///
/// Bit q is set when a landmark may appear in a direction within [q, q + kReach) bins, so that a query needs only
/// the lower end of its interval.
class VisibilityGrid
{
 public:
  static constexpr int kBins = 2048;                   ///< directions in a full turn
  static constexpr int kWords = kBins / 64;            ///< per cell
  static constexpr int kReach = 3;                     ///< [bins] see above
  static constexpr double kBinWidth = kTwoPi / kBins;  ///< [rad]

  /// Cells of a grid.
  struct Layout
  {
    Box2 area;
    double max_range = 0;  ///< [m], infinity for none
    double cell = 1;       ///< [m] side of a cell
    int columns = 0, rows = 0;
    double occupancy = 1;  ///< expected share of bits that are set

    [[nodiscard]] std::size_t cells() const
    {
      return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
  };
  /// Cells of such a size that the direction of a typical landmark changes by `motion` [bins] from the middle of
  /// a cell to its rim. Nothing for an area that is not finite, or when it would take more than 100 MB.
  [[nodiscard]] static std::optional<Layout> chooseLayout(const LandmarkIndex& map, const Box2& area, double max_range,
                                                          double motion);

  VisibilityGrid(const LandmarkIndex& map, const Layout& layout);

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] bool isOf(const Box2& area, double max_range) const
  {
    return layout_.area.min == area.min && layout_.area.max == area.max && layout_.max_range == max_range;
  }
  [[nodiscard]] const std::uint64_t* ring(std::size_t cell) const { return bits_.data() + cell * kWords; }
  [[nodiscard]] int closeLandmarks(std::size_t cell) const { return close_[cell]; }
  [[nodiscard]] Vector2d centre(std::size_t cell) const;
  /// Largest distance of a point of a cell from its centre [m].
  [[nodiscard]] double cellRadius() const { return layout_.cell * std::sqrt(0.5); }

 private:
  void fillRing(const std::vector<float>& direction, const std::vector<float>& half_width, std::size_t cell);

  Layout layout_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint8_t> close_;
};
}  // namespace mrpt_ext
