#include "mrpt_ext/filter/modes/cell_kernel.h"

#include <cstring>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr float kFarthest = 1e9F;  // [cells] beyond it all is one cell

using Four [[gnu::vector_size(4 * sizeof(double))]] = double;

[[gnu::always_inline]] inline void add(const Four& terms, double (&sums)[4])
{
  Four sum;
  std::memcpy(&sum, sums, sizeof sum);
  sum += terms;
  std::memcpy(sums, &sum, sizeof sum);
}
}  // namespace

MRPT_EXT_VECTOR_CLONES
void divideIntoCells(const float* values, std::size_t count, float shift, float size, CellAxis& axis)
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

MRPT_EXT_VECTOR_CLONES
void addToCells(const CellChunk& chunk, std::size_t count, CellSums* sums)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = chunk.x.offset[i], y = chunk.y.offset[i], phi = chunk.phi.offset[i], w = chunk.weight[i];
    const Four d{1, x, y, phi}, next{1, y, phi, x};
    const Four weighted = d * w;
    CellSums& cell = sums[chunk.number[i] * kCellTurns + i % kCellTurns];
    add(weighted, cell.first);
    add(weighted * d, cell.squares);
    add(weighted * next, cell.products);
  }
}

void CellSums::operator+=(const CellSums& more)
{
  for (std::size_t k = 0; k < 4; ++k)
  {
    first[k] += more.first[k];
    squares[k] += more.squares[k];
    products[k] += more.products[k];
  }
}
}  // namespace mrpt_ext
