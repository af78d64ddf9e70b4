#pragma once

#include <cstddef>
#include <cstdint>

namespace mrpt_ext
{
inline constexpr std::size_t kCellChunk = 512;  ///< particles taken at a time

/// Cell numbers along one axis, and offsets from the cells' middles.
struct CellAxis
{
  std::int32_t cell[kCellChunk];
  float offset[kCellChunk];
};

/// Divides `count` values, at most a chunk, into cells of `size`; `shift` [cells]: position of zero in its cell.
void divideIntoCells(const float* values, std::size_t count, float shift, float size, CellAxis& axis);

/// Sums over the particles of one cell, with d = (1, dx, dy, dphi) the offsets from the cell's middle: of w d, of the
/// squares w d d, and of the products w (1, dx, dy, dphi) (1, dy, dphi, dx).
struct alignas(32) CellSums
{
  double first[4] = {}, squares[4] = {}, products[4] = {};

  void operator+=(const CellSums& more);
};

/// The particles of one chunk, and the number of the cell that each is in.
struct CellChunk
{
  CellAxis x, y, phi;
  float weight[kCellChunk];
  std::uint32_t number[kCellChunk];
};

/// Every cell has this many sums, taken in turn: they need not wait for each other.
inline constexpr std::size_t kCellTurns = 4;

/// Adds particle i of the chunk to sums[number * kCellTurns + i % kCellTurns].
void addToCells(const CellChunk& chunk, std::size_t count, CellSums* sums);
}  // namespace mrpt_ext
