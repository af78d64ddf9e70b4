#include "mrpt_ext/correspondence/bearings/triple_scan.h"

#include <algorithm>
#include <array>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kBlock = 16, kTile = 256;
constexpr float kNearest2 = 1e-6F;  // [m^2] a landmark nearer to the sensor than this is not seen

/// One j with a tile of k: the position of the sensor, and whether it is possible.
struct Row
{
  alignas(64) std::array<float, kTile> x, y;
  alignas(64) std::array<std::int32_t, kTile> possible;
  alignas(64) std::array<float, kTile> vx, vy;  // centres of the circles through i and k
};

[[gnu::always_inline]] inline void mirrorRow(const TripleShape& shape, float jx, float jy, const float* kx,
                                             const float* ky, std::size_t size, Row& row)
{
  const float ux = 0.5F * (jx - shape.cot_first * jy), uy = 0.5F * (jy + shape.cot_first * jx);
  for (std::size_t l = 0; l < size; ++l)
  {
    const float ex = row.vx[l] - ux, ey = row.vy[l] - uy;
    const float length2 = ex * ex + ey * ey;
    const float t = 2 * (ux * ey - uy * ex) / (length2 > 1e-20F ? length2 : 1e-20F);
    const float px = t * ey, py = -t * ex;
    const float dx = jx - px, dy = jy - py, gx = kx[l] - px, gy = ky[l] - py;
    const float p2 = px * px + py * py, d2 = dx * dx + dy * dy, g2 = gx * gx + gy * gy;
    // Seen from there, the other landmarks must turn from i the way the bearings do, not half a turn away.
    const float turn_first = shape.sign_first * (py * dx - px * dy);
    const float turn_second = shape.sign_second * (py * gx - px * gy);
    row.x[l] = px;
    row.y[l] = py;
    row.possible[l] = (p2 <= shape.range2) & (d2 <= shape.range2) & (g2 <= shape.range2) & (p2 > kNearest2) &
                      (d2 > kNearest2) & (g2 > kNearest2) & (turn_first > 0) & (turn_second > 0);
  }
}

[[gnu::always_inline]] inline void appendPossible(const Row& row, std::size_t size, std::size_t j, std::size_t tile,
                                                  TripleHits& hits)
{
  std::array<std::uint32_t, kTile> lane;
  std::size_t found = 0;
  for (std::size_t l = 0; l < size; ++l)  // without a branch: every lane is written, the possible ones stay
  {
    lane[found] = static_cast<std::uint32_t>(l);
    found += static_cast<std::size_t>(row.possible[l]);
  }
  for (std::size_t f = 0; f < found; ++f)
  {
    hits.x[hits.count + f] = row.x[lane[f]];
    hits.y[hits.count + f] = row.y[lane[f]];
    hits.j[hits.count + f] = static_cast<std::uint32_t>(j);
    hits.k[hits.count + f] = lane[f] + static_cast<std::uint32_t>(tile);
  }
  hits.count += found;
}
}  // namespace

void Neighbours::reserve(std::size_t capacity)
{
  if (x.size() >= capacity) return;
  x.resize(capacity);
  y.resize(capacity);
}

void Neighbours::pad()
{
  padded = (count + kBlock - 1) / kBlock * kBlock;
  reserve(padded);
  std::fill(x.begin() + static_cast<std::ptrdiff_t>(count), x.begin() + static_cast<std::ptrdiff_t>(padded), 0.0F);
  std::fill(y.begin() + static_cast<std::ptrdiff_t>(count), y.begin() + static_cast<std::ptrdiff_t>(padded), 0.0F);
}

void TripleHits::reserve(std::size_t capacity)
{
  if (x.size() >= capacity) return;
  for (auto* v : {&x, &y}) v->resize(capacity);
  for (auto* v : {&j, &k}) v->resize(capacity);
}

MRPT_EXT_VECTOR_CLONES
void scanTriples(const TripleShape& shape, const Neighbours& first, std::size_t j_begin, std::size_t j_end,
                 const Neighbours& second, TripleHits& hits)
{
  Row row;
  for (std::size_t tile = 0; tile < second.count; tile += kTile)
  {
    const std::size_t size = std::min(kTile, second.padded - tile);
    const float *kx = second.x.data() + tile, *ky = second.y.data() + tile;
    for (std::size_t l = 0; l < size; ++l)
    {
      row.vx[l] = 0.5F * (kx[l] - shape.cot_second * ky[l]);
      row.vy[l] = 0.5F * (ky[l] + shape.cot_second * kx[l]);
    }
    for (std::size_t j = j_begin; j < j_end; ++j)
    {
      mirrorRow(shape, first.x[j], first.y[j], kx, ky, size, row);
      appendPossible(row, size, j, tile, hits);
    }
  }
}
}  // namespace mrpt_ext
