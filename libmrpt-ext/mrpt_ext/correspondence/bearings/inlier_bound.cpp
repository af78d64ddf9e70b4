#include "mrpt_ext/correspondence/bearings/inlier_bound.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <bit>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr float kUnlimited = 1e8F;  // [m]

/// A sensor pose relative to the centre of its cell, with the uncertainty of the tested pose.
struct TestedPose
{
  float x, y, c, s;
  float mx, my;  // from the tested sensor to this one, world axes
  float ix, iy, ih, jx, jy, jh, kx, ky, kh;
  float range2;
};

/// One landmark as seen from a tested pose.
struct LandmarkGate
{
  std::uint32_t inliers;
  float x, y, ex, ey, w, variance;
};

/// A direction table in the form of the inner loop.
struct TableInFloat
{
  const std::uint32_t *sets, *of_category, *from_category;
  float inverse_variance, scale;
  int bins, last_level;

  explicit TableInFloat(const DirectionTable& t)
      : sets(t.sets()),
        of_category(t.ofCategory()),
        from_category(t.fromCategory()),
        inverse_variance(t.inverseVariance()),
        scale(0.25F * static_cast<float>(t.bins())),
        bins(t.bins()),
        last_level(t.levels() - 1)
  {
  }
};

template <bool HasCategories>
[[gnu::always_inline]] inline LandmarkGate gateOf(const TestedPose& p, const TableInFloat& table, float landmark_x,
                                                  float landmark_y, std::uint8_t category)
{
  const float dx = landmark_x - p.x, dy = landmark_y - p.y;
  const float d2 = dx * dx + dy * dy;
  const float r2 = d2 > 1e-6F ? d2 : 1e-6F;
  const float bx = p.c * dx + p.s * dy, by = p.c * dy - p.s * dx;
  const float norm = std::abs(bx) + std::abs(by) + 1e-9F;
  const float inverse = 1 / (r2 * norm);  // one division for 1 / r2 and 1 / norm
  const float along = by * (inverse * r2);
  const float ex = dy * (inverse * norm), ey = -dx * (inverse * norm);
  const float w = 1 + (p.mx * dx + p.my * dy) * (inverse * norm);
  const float vi = ex * p.ix + ey * p.iy - w * p.ih, vj = ex * p.jx + ey * p.jy - w * p.jh;
  const float vk = ex * p.kx + ey * p.ky - w * p.kh;
  const float variance = vi * vi + vj * vj + vk * vk;
  const float ratio = 1 + table.inverse_variance * variance;
  const int step = (std::bit_cast<int>(ratio) >> DirectionTable::kShift) - DirectionTable::kFirstStep;
  const int level = step < table.last_level ? step : table.last_level;
  const int bin = static_cast<int>((bx < 0 ? 3 - along : 1 + along) * table.scale) & (table.bins - 1);
  std::uint32_t set = table.sets[level * table.bins + bin];
  if constexpr (HasCategories) set &= table.of_category[category];
  return {set & (r2 <= p.range2 ? ~0U : 0U), bx, by, ex, ey, w, variance};
}

/// A scan in the form of the inner loop.
struct ScanInFloat
{
  double origin_x, origin_y, cell, inverse_cell;
  int columns, rows;
  float tx, ty, tc, ts, range;
};

ScanInFloat inFloat(const BoundingScan& scan, const Vector2d& around)
{
  const PotentiallyVisibleSets& visible_sets = *scan.visible_sets;
  const Pose2& T = scan.T_tested_sensor;
  const Vector2d origin = visible_sets.origin() - around;
  return {origin.x(),
          origin.y(),
          visible_sets.cellSize(),
          1 / visible_sets.cellSize(),
          visible_sets.columns(),
          visible_sets.rows(),
          static_cast<float>(T.x),
          static_cast<float>(T.y),
          static_cast<float>(std::cos(T.phi)),
          static_cast<float>(std::sin(T.phi)),
          std::min(static_cast<float>(visible_sets.maxRange()), kUnlimited)};
}

/// Landmarks are sorted by category: with categories a pose is given up as soon as the remaining ones cannot bring it
/// to `needed`.
template <bool HasCategories>
[[gnu::always_inline]] inline void addInliers(const TriplePoses& poses, const BoundingScan& scan, const ScanInFloat& v,
                                              float gate, int needed, std::uint16_t* inliers)
{
  const TableInFloat table(*scan.table);
  for (std::size_t n = 0; n < poses.count; ++n)
  {
    const float c = poses.c[n], s = poses.s[n];
    const float mx = c * v.tx - s * v.ty, my = s * v.tx + c * v.ty;
    const double gx = static_cast<double>(poses.x[n] + mx) - v.origin_x;
    const double gy = static_cast<double>(poses.y[n] + my) - v.origin_y;
    const int column = std::clamp(static_cast<int>(gx * v.inverse_cell), 0, v.columns - 1);
    const int row = std::clamp(static_cast<int>(gy * v.inverse_cell), 0, v.rows - 1);
    const PotentiallyVisibleSets::Cell cell =
        scan.visible_sets->cell(static_cast<std::size_t>(row) * v.columns + column);
    const float ix = poses.ix[n], iy = poses.iy[n], jx = poses.jx[n], jy = poses.jy[n], kx = poses.kx[n];
    const float ky = poses.ky[n];
    const float reach = v.range + gate * std::sqrt(ix * ix + iy * iy + jx * jx + jy * jy + kx * kx + ky * ky);
    const TestedPose pose{static_cast<float>(gx - (column + 0.5) * v.cell),
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
    std::uint32_t set = scan.used;
    const std::size_t block = HasCategories ? PotentiallyVisibleSets::kBlock : cell.count;
    for (std::size_t begin = 0; begin < cell.count; begin += block)
    {
      if (HasCategories && inliers[n] + std::popcount(set | table.from_category[cell.category[begin]]) < needed) break;
      for (std::size_t l = begin; l < begin + block; ++l)
        set |= gateOf<HasCategories>(pose, table, cell.x[l], cell.y[l], cell.category[l]).inliers;
    }
    inliers[n] = static_cast<std::uint16_t>(inliers[n] + std::popcount(set));
  }
}

MRPT_EXT_VECTOR_CLONES
void addInliersAnyCategory(const TriplePoses& poses, const BoundingScan& scan, const ScanInFloat& v, float gate,
                           int needed, std::uint16_t* inliers)
{
  addInliers<false>(poses, scan, v, gate, needed, inliers);
}

MRPT_EXT_VECTOR_CLONES
void addInliersOfCategory(const TriplePoses& poses, const BoundingScan& scan, const ScanInFloat& v, float gate,
                          int needed, std::uint16_t* inliers)
{
  addInliers<true>(poses, scan, v, gate, needed, inliers);
}
}  // namespace

void boundInliers(const TriplePoses& poses, const Vector2d& around, std::span<const BoundingScan> scans, double gate,
                  int least, std::vector<std::uint16_t>& inliers)
{
  inliers.assign(poses.count, 0);
  int needed = least;
  for (const BoundingScan& scan : scans) needed -= scan.table->size();
  for (const BoundingScan& scan : scans)
  {
    needed += scan.table->size();  // the scans to come may associate all theirs
    const ScanInFloat v = inFloat(scan, around);
    const auto add = scan.table->hasCategories() ? addInliersOfCategory : addInliersAnyCategory;
    add(poses, scan, v, static_cast<float>(gate), needed, inliers.data());
  }
}

namespace
{
MRPT_EXT_VECTOR_CLONES
void gateAll(const TestedPose& pose, const TableInFloat& table, const PotentiallyVisibleSets::Cell& cell,
             GatedLandmarks& seen)
{
  std::uint32_t* __restrict inliers = seen.inliers.data();
  float* __restrict x = seen.x.data(), * __restrict y = seen.y.data(), * __restrict variance = seen.variance.data();
  float* __restrict ex = seen.ex.data(), * __restrict ey = seen.ey.data(), * __restrict w = seen.w.data();
  for (std::size_t l = 0; l < cell.count; ++l)
  {
    const LandmarkGate gate_of = gateOf<true>(pose, table, cell.x[l], cell.y[l], cell.category[l]);
    inliers[l] = gate_of.inliers;
    x[l] = gate_of.x;
    y[l] = gate_of.y;
    ex[l] = gate_of.ex;
    ey[l] = gate_of.ey;
    w[l] = gate_of.w;
    variance[l] = gate_of.variance;
  }
}

/// A box of sensor poses relative to the centre of a cell.
struct TestedBox
{
  float x, y, c, s;
  float side2, turn2;  // variances
  float range2;
};

struct BoxCount
{
  std::uint32_t inliers = 0;
  int close = 0;
};

/// As gateOf, for a box.
MRPT_EXT_VECTOR_CLONES
BoxCount boundFromBox(const TestedBox& box, const TableInFloat& table, const PotentiallyVisibleSets::Cell& cell)
{
  std::uint32_t inliers = 0;
  int close = 0;
  for (std::size_t l = 0; l < cell.count; ++l)
  {
    const float dx = cell.x[l] - box.x, dy = cell.y[l] - box.y;
    const float d2 = dx * dx + dy * dy;
    const float r2 = d2 > 1e-6F ? d2 : 1e-6F;
    const float bx = box.c * dx + box.s * dy, by = box.c * dy - box.s * dx;
    const float norm = std::abs(bx) + std::abs(by) + 1e-9F;
    const float inverse = 1 / (r2 * norm);
    const float along = by * (inverse * r2);
    const float ratio = 1 + table.inverse_variance * (box.side2 * (inverse * norm) + box.turn2);
    const int step = (std::bit_cast<int>(ratio) >> DirectionTable::kShift) - DirectionTable::kFirstStep;
    const int level = step < table.last_level ? step : table.last_level;
    const int bin = static_cast<int>((bx < 0 ? 3 - along : 1 + along) * table.scale) & (table.bins - 1);
    const std::uint32_t in_range = r2 <= box.range2 ? ~0U : 0U;
    const std::uint32_t set = table.sets[level * table.bins + bin] & table.of_category[cell.category[l]] & in_range;
    std::uint32_t rest = set;
    for (int n = 0; n < kMostOfOneLandmark; ++n) rest &= rest - 1;
    inliers |= rest == 0 ? set : 0U;
    close += rest == 0 ? 0 : 1;
  }
  return {inliers, close};
}

/// A matrix F with F F^T = C; where rounding has made C indefinite, one with F F^T >= C.
Matrix3d factorOf(const Matrix3d& covariance)
{
  const Eigen::LLT<Matrix3d> llt(covariance);
  if (llt.info() == Eigen::Success) return llt.matrixL();
  return (3 * covariance.diagonal().cwiseMax(0)).cwiseSqrt().asDiagonal();
}
}  // namespace

void landmarkGates(const GaussianPose& tested, const BoundingScan& scan, double gate, GatedLandmarks& seen)
{
  const Pose2 sensor = compose(tested.mean, scan.T_tested_sensor);
  const PotentiallyVisibleSets::CellAt at = scan.visible_sets->cellAt(sensor.position());
  const Eigen::Matrix3f f = factorOf(tested.covariance).cast<float>();
  const Eigen::Vector2f position = (sensor.position() - at.centre).cast<float>();
  const Eigen::Vector2f offset = (sensor.position() - tested.mean.position()).cast<float>();
  const auto reach = static_cast<float>(scan.visible_sets->maxRange() +
                                        gate * std::sqrt(tested.covariance.topLeftCorner<2, 2>().trace()));
  const float range = std::min(reach, kUnlimited);
  const TestedPose pose{position.x(),
                        position.y(),
                        static_cast<float>(std::cos(sensor.phi)),
                        static_cast<float>(std::sin(sensor.phi)),
                        offset.x(),
                        offset.y(),
                        f(0, 0),
                        f(1, 0),
                        f(2, 0),
                        0,
                        f(1, 1),
                        f(2, 1),
                        0,
                        0,
                        f(2, 2),
                        range * range};
  seen.count = at.cell.count;
  if (seen.x.size() < seen.count)
  {
    seen.inliers.resize(seen.count);
    for (auto* v : {&seen.x, &seen.y, &seen.ex, &seen.ey, &seen.w, &seen.variance}) v->resize(seen.count);
  }
  gateAll(pose, TableInFloat(*scan.table), at.cell, seen);
}

int boundOfBox(const GaussianPose& box, const BoundingScan& scan, double gate)
{
  const Vector2d position = box.mean.position();
  const PotentiallyVisibleSets::CellAt at = scan.visible_sets->cellAt(position);
  const double side2 = box.covariance(0, 0);
  const double reach = scan.visible_sets->maxRange() + gate * std::sqrt(2 * side2);
  const auto range = std::min(static_cast<float>(reach), kUnlimited);
  const TestedBox tested{static_cast<float>(position.x() - at.centre.x()),
                         static_cast<float>(position.y() - at.centre.y()),
                         static_cast<float>(std::cos(box.mean.phi)),
                         static_cast<float>(std::sin(box.mean.phi)),
                         static_cast<float>(side2),
                         static_cast<float>(box.covariance(2, 2)),
                         range * range};
  const BoxCount count = boundFromBox(tested, TableInFloat(*scan.table), at.cell);
  return std::min(scan.table->size(), std::popcount(count.inliers | scan.used) + count.close);
}
}  // namespace mrpt_ext
