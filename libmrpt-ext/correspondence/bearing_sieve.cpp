#include "mrpt_ext/correspondence/bearing_sieve.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr int kStepBits = 1;                  // of the mantissa: steps per factor 2 of the variance
constexpr int kShift = 23 - kStepBits;        // from a float's bits to its step
constexpr int kFirstStep = 127 << kStepBits;  // step of the float 1
constexpr double kWidestGate = 0.5;           // [rad] beyond this a landmark may explain anything
constexpr int kMinBins = 512, kMaxBins = 8192;
constexpr std::size_t kKinds = 256;
constexpr float kUnlimited = 1e8F;  // [m]

/// Pseudo-angle in [0, 4).
double pseudoAngle(double angle)
{
  const double x = std::cos(angle), y = std::sin(angle);
  const double p = y / (std::abs(x) + std::abs(y));
  return x < 0 ? 3 - p : 1 + p;
}

/// Upper end of the variance ratios of a step.
double ratioAbove(int step)
{
  return std::ldexp(1 + static_cast<double>((step & ((1 << kStepBits) - 1)) + 1) / (1 << kStepBits), step >> kStepBits);
}
}  // namespace

ReadingTable::ReadingTable(std::span<const BearingReading> readings, double gate)
    : size_(static_cast<int>(std::min(readings.size(), kMaxReadings))),
      of_kind_(kKinds, 0),
      readings_(readings.begin(), readings.end())
{
  double widest = 0;
  for (const BearingReading& r : readings) widest = std::max(widest, r.std);
  if (!(widest > 0)) return;
  inverse_variance_ = static_cast<float>(1 / square(widest));
  const double narrow = gate * widest;
  bins_ =
      static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(8 / narrow, 1.0 * kMinBins, 1.0 * kMaxBins))));
  levels_ = 1;
  while (narrow * std::sqrt(ratioAbove(levels_ - 1)) < kWidestGate) ++levels_;
  sets_.assign(static_cast<std::size_t>(levels_) * static_cast<std::size_t>(bins_), 0);
  for (int i = 0; i < size_; ++i)
  {
    const BearingReading& reading = readings[static_cast<std::size_t>(i)];
    const std::uint32_t bit = 1U << i;
    for (std::size_t kind = 0; kind < kKinds; ++kind)
      if (reading.kind == kAnyKind || (static_cast<std::size_t>(reading.kind) % kKinds) == kind) of_kind_[kind] |= bit;
    has_kinds_ = has_kinds_ || reading.kind != kAnyKind;
    for (int level = 0; level < levels_; ++level)
    {
      const double excess = (ratioAbove(level) - 1) * square(widest);
      const double half_width = level + 1 == levels_ ? kPi : gate * std::sqrt(square(reading.std) + excess);
      addReading(bit, reading.bearing, half_width,
                 sets_.data() + static_cast<std::size_t>(level) * static_cast<std::size_t>(bins_));
    }
  }
}

void ReadingTable::addReading(std::uint32_t bit, double bearing, double half_width, std::uint32_t* level) const
{
  const auto bin_of = [&](double angle) { return static_cast<int>(pseudoAngle(angle) * bins_ / 4); };
  const double rounding = 1e-5;  // of the float arithmetic that looks up
  int first = 0, count = bins_;
  if (half_width + rounding < kPi / 2)
  {
    first = bin_of(bearing - half_width - rounding) & (bins_ - 1);
    count = ((bin_of(bearing + half_width + rounding) - first) & (bins_ - 1)) + 1;
  }
  for (int b = 0; b < count; ++b) level[(first + b) & (bins_ - 1)] |= bit;
}

int ReadingTable::levelOf(float ratio) const
{
  return std::min((std::bit_cast<int>(ratio) >> kShift) - kFirstStep, levels_ - 1);
}

std::uint32_t ReadingTable::explainedBy(float x, float y, float ratio, std::uint8_t kind) const
{
  const float along = y / (std::abs(x) + std::abs(y) + 1e-9F);
  const int bin = static_cast<int>((x < 0 ? 3 - along : 1 + along) * 0.25F * static_cast<float>(bins_)) & (bins_ - 1);
  return sets_[static_cast<std::size_t>(levelOf(ratio) * bins_ + bin)] & of_kind_[kind];
}

namespace
{
/// A sensor pose relative to the centre of its cell, with the uncertainty of the tested pose.
struct SievePose
{
  float x, y, c, s;
  float mx, my;  // from the tested sensor to this one, world axes
  float ix, iy, ih, jx, jy, jh, kx, ky, kh;
  float range2;
};

template <bool kHasKinds>
[[gnu::always_inline]] inline std::uint32_t explainedSet(const SievePose& p, const VisibleLists::Cell& cell,
                                                         const std::uint32_t* sets, const std::uint32_t* of_kind,
                                                         float inverse_variance, int bins, int last_level)
{
  std::uint32_t explained = 0;
  const float scale = 0.25F * static_cast<float>(bins);
  for (std::size_t l = 0; l < cell.count; ++l)
  {
    const float dx = cell.x[l] - p.x, dy = cell.y[l] - p.y;
    const float d2 = dx * dx + dy * dy;
    const float r2 = d2 > 1e-6F ? d2 : 1e-6F;
    const float bx = p.c * dx + p.s * dy, by = p.c * dy - p.s * dx;
    const float norm = std::abs(bx) + std::abs(by) + 1e-9F;
    const float inverse = 1 / (r2 * norm);
    const float along = by * (inverse * r2);
    const float ex = dy * (inverse * norm), ey = -dx * (inverse * norm);
    const float w = 1 + (p.mx * dx + p.my * dy) * (inverse * norm);
    const float vi = ex * p.ix + ey * p.iy - w * p.ih, vj = ex * p.jx + ey * p.jy - w * p.jh;
    const float vk = ex * p.kx + ey * p.ky - w * p.kh;
    const float ratio = 1 + inverse_variance * (vi * vi + vj * vj + vk * vk);
    const int step = (std::bit_cast<int>(ratio) >> kShift) - kFirstStep;
    const int level = step < last_level ? step : last_level;
    const int bin = static_cast<int>((bx < 0 ? 3 - along : 1 + along) * scale) & (bins - 1);
    std::uint32_t set = sets[level * bins + bin];
    if constexpr (kHasKinds) set &= of_kind[cell.kind[l]];
    explained |= set & (r2 <= p.range2 ? ~0U : 0U);
  }
  return explained;
}

/// What the inner loop needs of a view.
struct ViewInFloat
{
  double origin_x, origin_y, cell, inverse_cell;
  int columns, rows;
  float tx, ty, tc, ts, range;
};

ViewInFloat inFloat(const SieveView& view, const Vector2d& around)
{
  const VisibleLists& lists = *view.lists;
  const Pose2& T = view.T_tested_sensor;
  const Vector2d origin = lists.origin() - around;
  return {origin.x(),
          origin.y(),
          lists.cellSize(),
          1 / lists.cellSize(),
          lists.columns(),
          lists.rows(),
          static_cast<float>(T.x),
          static_cast<float>(T.y),
          static_cast<float>(std::cos(T.phi)),
          static_cast<float>(std::sin(T.phi)),
          std::min(static_cast<float>(lists.maxRange()), kUnlimited)};
}

template <bool kHasKinds>
[[gnu::always_inline]] inline void addExplained(const TriplePoses& poses, const SieveView& view, const ViewInFloat& v,
                                                float gate, std::uint8_t* explained)
{
  const ReadingTable& table = *view.table;
  const std::uint32_t *sets = table.sets(), *of_kind = table.ofKind();
  const float inverse_variance = table.inverseVariance();
  const int bins = table.bins(), last_level = table.levels() - 1;
  for (std::size_t n = 0; n < poses.count; ++n)
  {
    const float c = poses.c[n], s = poses.s[n];
    const float mx = c * v.tx - s * v.ty, my = s * v.tx + c * v.ty;
    const double gx = static_cast<double>(poses.x[n] + mx) - v.origin_x;
    const double gy = static_cast<double>(poses.y[n] + my) - v.origin_y;
    const int column = std::clamp(static_cast<int>(gx * v.inverse_cell), 0, v.columns - 1);
    const int row = std::clamp(static_cast<int>(gy * v.inverse_cell), 0, v.rows - 1);
    const VisibleLists::Cell cell = view.lists->cell(static_cast<std::size_t>(row) * v.columns + column);
    const float ix = poses.ix[n], iy = poses.iy[n], jx = poses.jx[n], jy = poses.jy[n], kx = poses.kx[n];
    const float ky = poses.ky[n];
    const float reach = v.range + gate * std::sqrt(ix * ix + iy * iy + jx * jx + jy * jy + kx * kx + ky * ky);
    const SievePose pose{static_cast<float>(gx - (column + 0.5) * v.cell),
                         static_cast<float>(gy - (row + 0.5) * v.cell),
                         c * v.tc - s * v.ts,
                         s * v.tc + c * v.ts,
                         mx,
                         my,
                         ix,
                         iy,
                         poses.ih[n],
                         jx,
                         jy,
                         poses.jh[n],
                         kx,
                         ky,
                         poses.kh[n],
                         reach * reach};
    const std::uint32_t set =
        view.used | explainedSet<kHasKinds>(pose, cell, sets, of_kind, inverse_variance, bins, last_level);
    explained[n] = static_cast<std::uint8_t>(explained[n] + std::popcount(set));
  }
}

MRPT_EXT_VECTOR_CLONES
void addExplainedAnyKind(const TriplePoses& poses, const SieveView& view, const ViewInFloat& v, float gate,
                         std::uint8_t* explained)
{
  addExplained<false>(poses, view, v, gate, explained);
}

MRPT_EXT_VECTOR_CLONES
void addExplainedOfKind(const TriplePoses& poses, const SieveView& view, const ViewInFloat& v, float gate,
                        std::uint8_t* explained)
{
  addExplained<true>(poses, view, v, gate, explained);
}
}  // namespace

void boundExplained(const TriplePoses& poses, const Vector2d& around, std::span<const SieveView> views, double gate,
                    std::vector<std::uint8_t>& explained)
{
  explained.assign(poses.count, 0);
  for (const SieveView& view : views)
  {
    const ViewInFloat v = inFloat(view, around);
    const auto add = view.table->hasKinds() ? addExplainedOfKind : addExplainedAnyKind;
    add(poses, view, v, static_cast<float>(gate), explained.data());
  }
}
}  // namespace mrpt_ext
