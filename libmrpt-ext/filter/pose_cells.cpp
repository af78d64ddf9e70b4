#include "mrpt_ext/filter/pose_cells.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particle_blocks.h"
#include "mrpt_ext/filter/weight_kernels.h"
#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kChunk = 512;
constexpr float kFarthest = 1e9F;  // [cells] beyond it all is one cell

/// Cell numbers along one axis and offsets from the cells' middles.
struct Axis
{
  std::int32_t cell[kChunk];
  float offset[kChunk];
};

/// `shift` [cells]: where zero lies in its cell, so that cells begin at whole multiples in the map frame.
MRPT_EXT_VECTOR_CLONES
void divide(const float* values, std::size_t count, float shift, float size, Axis& axis)
{
  const float inverse = 1.0F / size;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < count; ++i)
  {
    float at = values[i] * inverse + shift;
    at = at < kFarthest ? at : kFarthest;
    at = at > -kFarthest ? at : -kFarthest;
    const auto cut = static_cast<std::int32_t>(at);
    const std::int32_t cell = cut - (static_cast<float>(cut) > at ? 1 : 0);
    axis.cell[i] = cell;
    axis.offset[i] = (at - (static_cast<float>(cell) + 0.5F)) * size;
  }
}

std::uint64_t mixed(std::uint64_t v)
{
  v *= 0x9e3779b97f4a7c15ULL;
  return v ^ (v >> 32);
}
}  // namespace

void CellMoments::operator+=(const CellMoments& more)
{
  weight += more.weight;
  first += more.first;
  xx += more.xx;
  xy += more.xy;
  xp += more.xp;
  yy += more.yy;
  yp += more.yp;
  pp += more.pp;
}

std::size_t PoseCells::Index::slotOf(const Cell& cell, const std::vector<Cell>& cells) const
{
  const auto low = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.x));
  const auto high = static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.y));
  std::size_t slot = mixed(mixed(low | high << 32) + static_cast<std::uint64_t>(cell.phi)) & (slots.size() - 1);
  while (slots[slot] != kNone && !(cells[slots[slot]] == cell)) slot = (slot + 1) & (slots.size() - 1);
  return slot;
}

std::uint32_t PoseCells::Index::insert(const Cell& cell, std::vector<Cell>& cells)
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

PoseCells::PoseCells(const ParticleSet& particles, double cell_xy, double cell_phi, unsigned threads)
    : origin_(particles.origin),
      cell_xy_(cell_xy),
      turns_(static_cast<std::int32_t>(std::max(1LL, std::llround(kTwoPi / cell_phi)))),
      cell_of_(particles.size())
{
  cell_phi_ = kTwoPi / turns_;
  std::vector<Gathered> blocks(blockCount(particles.size()));
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               { gather(particles, first, count, blocks[first / kParticleBlock]); });
  std::vector<std::vector<std::uint32_t>> joined;
  for (Gathered& block : blocks)
  {
    auto& numbers = joined.emplace_back();
    for (std::size_t k = 0; k < block.cells.size(); ++k)
    {
      numbers.push_back(index_.insert(block.cells[k], cells_));
      moments_.resize(cells_.size());
      moments_[numbers.back()] += block.moments[k];
    }
  }
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 const auto& numbers = joined[first / kParticleBlock];
                 for (std::size_t i = first; i < first + count; ++i) cell_of_[i] = numbers[cell_of_[i]];
               });
}

void PoseCells::gather(const ParticleSet& particles, std::size_t first, std::size_t count, Gathered& block)
{
  const auto shift_of = [&](double origin)
  { return static_cast<float>(origin / cell_xy_ - std::floor(origin / cell_xy_)); };
  const float shift_x = shift_of(origin_.x()), shift_y = shift_of(origin_.y());
  const auto size = static_cast<float>(cell_xy_), turn = static_cast<float>(cell_phi_);
  Axis x, y, phi;
  float weight[kChunk];
  std::uint32_t number = kNone;  // neighbours in the list are often neighbours in the room
  for (const std::size_t end = first + count; first < end; first += kChunk)
  {
    const std::size_t n = std::min(kChunk, end - first);
    divide(&particles.x[first], n, shift_x, size, x);
    divide(&particles.y[first], n, shift_y, size, y);
    divide(&particles.phi[first], n, 0.5F * static_cast<float>(turns_), turn, phi);
    exponentials(std::span(particles.log_weight).subspan(first, n), 0, std::span(weight).first(n));
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::int32_t heading =
          phi.cell[i] >= 0 && phi.cell[i] < turns_ ? phi.cell[i] : ((phi.cell[i] % turns_) + turns_) % turns_;
      const Cell cell{x.cell[i], y.cell[i], heading};
      if (number == kNone || !(block.cells[number] == cell)) number = block.index.insert(cell, block.cells);
      cell_of_[first + i] = number;
      if (number == block.moments.size()) block.moments.emplace_back();
      CellMoments& sums = block.moments[number];
      const double w = weight[i], dx = x.offset[i], dy = y.offset[i], dp = phi.offset[i];
      sums.weight += w;
      sums.first += w * Vector3d(dx, dy, dp);
      sums.xx += w * dx * dx;
      sums.xy += w * dx * dy;
      sums.xp += w * dx * dp;
      sums.yy += w * dy * dy;
      sums.yp += w * dy * dp;
      sums.pp += w * dp * dp;
    }
  }
}

std::uint32_t PoseCells::find(const Cell& cell) const { return index_.slots[index_.slotOf(cell, cells_)]; }

Pose2 PoseCells::middle(std::size_t cell) const
{
  const auto along = [&](double origin, std::int32_t number)
  { return (std::floor(origin / cell_xy_) + number + 0.5) * cell_xy_; };
  const Cell& c = cells_[cell];
  return {along(origin_.x(), c.x), along(origin_.y(), c.y), wrap((c.phi + 0.5) * cell_phi_ - kPi)};
}
}  // namespace mrpt_ext
