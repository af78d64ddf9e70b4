#pragma once

#include <cstdint>
#include <vector>

#include "mrpt_ext/filter/modes/cell_kernel.h"
#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// Moments of the particles of one cell: sum of the weights, first and second moments about the centre of the cell in
/// the order (x, y, phi) [m, m, rad].
struct CellMoments
{
  double weight = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
};

/// Histogram of particles over (x, y, phi). It keeps the occupied cells only, in order of first appearance; the heading
/// wraps at +-pi. Each block of particles has a histogram of its own, and the blocks are joined in order, so the result
/// does not depend on the number of threads.
class PoseHistogram
{
 public:
  struct Cell
  {
    std::int32_t x, y, phi;
    [[nodiscard]] bool operator==(const Cell& other) const { return x == other.x && y == other.y && phi == other.phi; }
  };

  /// `particles`: normalised. Cells of `cell_xy` [m] and about `cell_phi` [rad]. `buffer` is reused for cell numbers.
  PoseHistogram(const ParticleSet& particles, double cell_xy, double cell_phi, unsigned threads,
                std::vector<int> buffer = {});

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] double weight(std::size_t cell) const { return sums_[cell].first[0]; }
  [[nodiscard]] CellMoments moments(std::size_t cell) const;
  [[nodiscard]] Pose2 middle(std::size_t cell) const;
  /// The label of every particle's cell. Call it last: it consumes the cell numbers of the particles.
  [[nodiscard]] std::vector<int> labelParticles(const std::vector<int>& label_of_cell, unsigned threads) &&;

  /// Calls `visit(cell)` for every occupied one of the 26 neighbours of a cell.
  template <typename Visit>
  void forNeighbours(std::size_t cell, Visit&& visit) const
  {
    const Cell& c = cells_[cell];
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dphi = -1; dphi <= 1; ++dphi)
        {
          const std::uint32_t found = find({c.x + dx, c.y + dy, (c.phi + dphi + turns_) % turns_});
          if (found != kNone && found != cell) visit(std::size_t{found});
        }
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Hash table of cell numbers with open addressing; its size is a power of two.
  struct Index
  {
    std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(64, kNone);
    [[nodiscard]] std::size_t slotOf(const Cell& cell, const std::vector<Cell>& cells) const;
    std::uint32_t insert(const Cell& cell, std::vector<Cell>& cells);
  };
  struct Gathered
  {
    Index index;
    std::vector<Cell> cells;
    std::vector<CellSums> sums;
  };

  class NearCells;

  void gather(const ParticleSet& particles, std::size_t first, std::size_t count, Gathered& block);
  [[nodiscard]] std::uint32_t find(const Cell& cell) const;

  Vector2d origin_;
  double cell_xy_, cell_phi_;
  std::int32_t turns_;
  Index index_;
  std::vector<Cell> cells_;
  std::vector<CellSums> sums_;
  std::vector<std::vector<std::uint32_t>> global_cells_;  // per block: the numbers of its cells in `cells_`
  std::vector<int> cell_of_;                              // per particle: its cell's number within its block
};
}  // namespace mrpt_ext
