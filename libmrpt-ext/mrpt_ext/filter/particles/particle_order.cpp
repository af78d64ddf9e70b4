#include "mrpt_ext/filter/particles/particle_order.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace mrpt_ext
{
namespace
{
constexpr int kBitsPerAxis = 10;

/// Cells of a coordinate, as bits that are two apart.
std::vector<std::uint32_t> spreadCells(const std::vector<float>& values)
{
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const float span = std::max(*high - *low, 1e-6F), first = *low;
  constexpr std::uint32_t kLast = (1U << kBitsPerAxis) - 1;
  std::vector<std::uint32_t> cells;
  for (const float value : values)
  {
    const auto cell = std::min(static_cast<std::uint32_t>((value - first) / span * static_cast<float>(kLast)), kLast);
    std::uint32_t bits = 0;
    for (int b = 0; b < kBitsPerAxis; ++b) bits |= (cell >> b & 1U) << (3 * b);
    cells.push_back(bits);
  }
  return cells;
}

void permute(std::vector<float>& column, const std::vector<std::size_t>& order)
{
  std::vector<float> moved;
  moved.reserve(column.size());
  for (const std::size_t i : order) moved.push_back(column[i]);
  column = std::move(moved);
}
}  // namespace

void orderByPlace(ParticleSet& particles)
{
  if (particles.empty()) return;
  std::vector<std::uint32_t> key(particles.size(), 0);
  int shift = 0;
  for (const std::vector<float>* column : {&particles.phi, &particles.x, &particles.y})
  {
    const std::vector<std::uint32_t> cells = spreadCells(*column);
    for (std::size_t i = 0; i < key.size(); ++i) key[i] |= cells[i] << shift;
    ++shift;
  }
  std::vector<std::size_t> order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  for (auto* column : {&particles.x, &particles.y, &particles.phi, &particles.log_weight}) permute(*column, order);
  for (std::vector<float>& column : particles.bias) permute(column, order);
}
}  // namespace mrpt_ext
