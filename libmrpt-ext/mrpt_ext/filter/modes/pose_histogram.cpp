#include "mrpt_ext/filter/modes/pose_histogram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/particles/weight_kernels.h"

namespace mrpt_ext
{
namespace
{
std::uint64_t mixed(std::uint64_t v)
{
  v *= 0x9e3779b97f4a7c15ULL;
  return v ^ (v >> 32);
}
}  // namespace

std::size_t PoseHistogram::Index::slotOf(const Cell& cell, const std::vector<Cell>& cells) const
{
  const auto low = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x));
  const auto high = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.y));
  std::size_t slot = mixed(mixed(low | high << 32) + static_cast<std::uint64_t>(cell.phi)) & (slots.size() - 1);
  while (slots[slot] != kNone && !(cells[slots[slot]] == cell)) slot = (slot + 1) & (slots.size() - 1);
  return slot;
}

std::uint32_t PoseHistogram::Index::insert(const Cell& cell, std::vector<Cell>& cells)
{
  std::size_t slot = slotOf(cell, cells);
  if (slots[slot] != kNone) return slots[slot];
  cells.push_back(cell);
  const auto number = static_cast<std::uint32_t>(cells.size() - 1);
  slots[slot] = number;
  if (2 * cells.size() > slots.size())
  {
    slots.assign(4 * slots.size(), kNone);
    for (std::uint32_t k = 0; k < cells.size(); ++k) slots[slotOf(cells[k], cells)] = k;
  }
  return number;
}

/// The cells about the first one asked for, in a table of their own: quicker than by hash, and mostly all there are.
class PoseHistogram::NearCells
{
 public:
  NearCells() { numbers_.fill(kNone); }

  std::uint32_t numberOf(const Cell& cell, Gathered& block)
  {
    if (block.cells.empty()) corner_ = {cell.x - kHalf, cell.y - kHalf, cell.phi - kHalf};
    const auto from = [](std::int32_t low, std::int32_t at)
    { return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(low); };
    const std::uint32_t x = from(corner_.x, cell.x), y = from(corner_.y, cell.y), phi = from(corner_.phi, cell.phi);
    if ((x | y | phi) >= kSide) return block.index.insert(cell, block.cells);
    std::uint32_t& number = numbers_[(x * kSide + y) * kSide + phi];
    if (number == kNone) number = block.index.insert(cell, block.cells);
    return number;
  }

 private:
  static constexpr std::size_t kSide = 8;  // a power of two
  static constexpr std::int32_t kHalf = kSide / 2;
  Cell corner_{};
  std::array<std::uint32_t, kSide * kSide * kSide> numbers_;
};

PoseHistogram::PoseHistogram(const ParticleSet& particles, double cell_xy, double cell_phi, unsigned threads,
                             std::vector<int> buffer)
    : origin_(particles.origin),
      cell_xy_(cell_xy),
      turns_(static_cast<std::int32_t>(std::max(1LL, std::llround(kTwoPi / cell_phi)))),
      cell_of_(std::move(buffer))
{
  cell_of_.resize(particles.size());
  cell_phi_ = kTwoPi / turns_;
  std::vector<Gathered> blocks(blockCount(particles.size()));
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               { gather(particles, first, count, blocks[first / kParticleBlock]); });
  for (const Gathered& block : blocks)
  {
    auto& numbers = global_cells_.emplace_back();
    for (std::size_t k = 0; k < block.cells.size(); ++k)
    {
      numbers.push_back(index_.insert(block.cells[k], cells_));
      sums_.resize(cells_.size());
      sums_[numbers.back()] += block.sums[k];
    }
  }
}

std::vector<int> PoseHistogram::labelParticles(const std::vector<int>& label_of_cell, unsigned threads) &&
{
  forEachBlock(cell_of_.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 std::vector<int> labels;
                 for (const std::uint32_t cell : global_cells_[first / kParticleBlock])
                   labels.push_back(label_of_cell[cell]);
                 for (std::size_t i = first; i < first + count; ++i)
                   cell_of_[i] = labels[static_cast<std::size_t>(cell_of_[i])];
               });
  return std::move(cell_of_);
}

void PoseHistogram::gather(const ParticleSet& particles, std::size_t first, std::size_t count, Gathered& block)
{
  const auto shift_of = [&](double origin)
  { return static_cast<float>(origin / cell_xy_ - std::floor(origin / cell_xy_)); };
  const float shift_x = shift_of(origin_.x()), shift_y = shift_of(origin_.y());
  const auto size = static_cast<float>(cell_xy_), turn = static_cast<float>(cell_phi_);
  CellChunk chunk;
  NearCells near;
  std::vector<CellSums> sums;
  for (const std::size_t end = first + count; first < end; first += kCellChunk)
  {
    const std::size_t n = std::min(kCellChunk, end - first);
    divideIntoCells(&particles.x[first], n, shift_x, size, chunk.x);
    divideIntoCells(&particles.y[first], n, shift_y, size, chunk.y);
    divideIntoCells(&particles.phi[first], n, 0.5F * static_cast<float>(turns_), turn, chunk.phi);
    exponentials(std::span(particles.log_weight).subspan(first, n), 0, std::span(chunk.weight).first(n));
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::int32_t phi = chunk.phi.cell[i];
      const std::int32_t heading = phi >= 0 && phi < turns_ ? phi : ((phi % turns_) + turns_) % turns_;
      chunk.number[i] = near.numberOf({chunk.x.cell[i], chunk.y.cell[i], heading}, block);
      cell_of_[first + i] = static_cast<int>(chunk.number[i]);
    }
    sums.resize(block.cells.size() * kCellTurns);
    addToCells(chunk, n, sums.data());
  }
  block.sums.resize(block.cells.size());
  for (std::size_t k = 0; k < sums.size(); ++k) block.sums[k / kCellTurns] += sums[k];
}

std::uint32_t PoseHistogram::find(const Cell& cell) const { return index_.slots[index_.slotOf(cell, cells_)]; }

CellMoments PoseHistogram::moments(std::size_t cell) const
{
  const CellSums& s = sums_[cell];
  CellMoments moments{.weight = s.first[0], .first = {s.first[1], s.first[2], s.first[3]}};
  moments.second << s.squares[1], s.products[1], s.products[3],  //
      s.products[1], s.squares[2], s.products[2],                //
      s.products[3], s.products[2], s.squares[3];
  return moments;
}

Pose2 PoseHistogram::middle(std::size_t cell) const
{
  const auto along = [&](double origin, std::int32_t number)
  { return (std::floor(origin / cell_xy_) + number + 0.5) * cell_xy_; };
  const Cell& c = cells_[cell];
  return {along(origin_.x(), c.x), along(origin_.y(), c.y), wrap((c.phi + 0.5) * cell_phi_ - kPi)};
}
}  // namespace mrpt_ext
