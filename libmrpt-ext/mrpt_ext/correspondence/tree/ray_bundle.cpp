#include "mrpt_ext/correspondence/tree/ray_bundle.h"

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLanes = 8, kCrossingMembers = 11;

/// Points of the inverse plane, p = -1 / d with d from the reference, and -p turned to unit length.
MRPT_EXT_VECTOR_CLONES void invertAll(const double* __restrict x, const double* __restrict y, double reference_x,
                                      double reference_y, std::size_t count, double* __restrict px,
                                      double* __restrict py, double* __restrict qx, double* __restrict qy)
{
  for (std::size_t l = 0; l < count; ++l)
  {
    const double dx = x[l] - reference_x, dy = y[l] - reference_y, d2 = dx * dx + dy * dy;
    const double inverse2 = d2 > 0 ? 1 / d2 : 0, inverse = std::sqrt(inverse2);
    px[l] = -dx * inverse2;
    py[l] = dy * inverse2;
    qx[l] = dx * inverse;
    qy[l] = -dy * inverse;
  }
}

MRPT_EXT_VECTOR_CLONES void rotateAll(const double* __restrict qx, const double* __restrict qy, double c, double s,
                                      std::size_t count, double* __restrict ux, double* __restrict uy)
{
  for (std::size_t l = 0; l < count; ++l)
  {
    ux[l] = c * qx[l] - s * qy[l];
    uy[l] = c * qy[l] + s * qx[l];
  }
}

/// The members of RayCrossing, an array each.
struct CrossingArrays
{
  std::int64_t* __restrict outcome;
  double* __restrict fx, * __restrict fy, * __restrict ax, * __restrict ay, * __restrict bx, * __restrict by;
  double* __restrict shift, * __restrict bend, * __restrict x, * __restrict y, * __restrict slack;

  CrossingArrays(std::int64_t* outcomes, double* memory, std::size_t size) : outcome(outcomes)
  {
    for (double* __restrict* array : {&fx, &fy, &ax, &ay, &bx, &by, &shift, &bend, &x, &y, &slack})
    {
      *array = memory;
      memory += size;
    }
  }

  [[nodiscard]] RayCrossing at(std::size_t l) const
  {
    return {static_cast<CrossingOutcome>(outcome[l]),
            fx[l],
            fy[l],
            ax[l],
            ay[l],
            bx[l],
            by[l],
            shift[l],
            bend[l],
            x[l],
            y[l],
            slack[l]};
  }
};

MRPT_EXT_VECTOR_CLONES void crossAll(InverseRay ray, const double* __restrict px, const double* __restrict py,
                                     const double* __restrict ux, const double* __restrict uy,
                                     const std::int64_t* __restrict mask, CrossingBounds bounds, std::size_t count,
                                     CrossingArrays out)
{
  for (std::size_t l = 0; l < count; ++l)
  {
    const RayCrossing c = crossRays(ray, {px[l], py[l], ux[l], uy[l]}, bounds);
    out.outcome[l] = static_cast<std::int64_t>(c.outcome) & mask[l];
    out.fx[l] = c.fx;
    out.fy[l] = c.fy;
    out.ax[l] = c.ax;
    out.ay[l] = c.ay;
    out.bx[l] = c.bx;
    out.by[l] = c.by;
    out.shift[l] = c.shift;
    out.bend[l] = c.bend;
    out.x[l] = c.x;
    out.y[l] = c.y;
    out.slack[l] = c.slack;
  }
}

struct GateArrays
{
  double* __restrict wx, * __restrict wy, * __restrict narrow, * __restrict wide;
};

template <bool Covariance>
[[gnu::always_inline]] inline void gateAll(RayCrossing crossing, double error, const double* __restrict px,
                                           const double* __restrict py, std::size_t count, GateArrays out)
{
  for (std::size_t l = 0; l < count; ++l)
  {
    const DirectionGate gate = gateAt<Covariance>(crossing, error, px[l], py[l]);
    out.wx[l] = gate.wx;
    out.wy[l] = gate.wy;
    out.narrow[l] = gate.narrow;
    out.wide[l] = gate.wide;
  }
}

MRPT_EXT_VECTOR_CLONES void gatesWorstCase(RayCrossing crossing, double error, const double* __restrict px,
                                           const double* __restrict py, std::size_t count, GateArrays out)
{
  gateAll<false>(crossing, error, px, py, count, out);
}

MRPT_EXT_VECTOR_CLONES void gatesCovariance(RayCrossing crossing, double error, const double* __restrict px,
                                            const double* __restrict py, std::size_t count, GateArrays out)
{
  gateAll<true>(crossing, error, px, py, count, out);
}

MRPT_EXT_VECTOR_CLONES std::int64_t admitAll(GateArrays gates, const double* __restrict ux, const double* __restrict uy,
                                             const std::int64_t* __restrict mask, std::size_t count,
                                             std::int64_t* __restrict result)
{
  std::int64_t found = 0;
  for (std::size_t l = 0; l < count; ++l)
  {
    const DirectionGate gate{gates.wx[l], gates.wy[l], gates.narrow[l], gates.wide[l]};
    result[l] = gate.admits(ux[l], uy[l]) ? mask[l] : 0;
    found -= result[l];
  }
  return found;
}
}  // namespace

RayBundle::RayBundle(std::span<const Vector2d> landmarks, std::vector<Vector2d> units, double error)
    : units_(std::move(units)), error_(error)
{
  const std::size_t size = (landmarks.size() + kLanes - 1) / kLanes * kLanes;
  for (std::vector<double>* array : {&x_, &y_, &px_, &py_, &qx_, &qy_, &wx_, &wy_, &narrow_, &wide_})
    array->assign(size, 0);
  for (std::size_t l = 0; l < landmarks.size(); ++l)
  {
    x_[l] = landmarks[l].x();
    y_[l] = landmarks[l].y();
  }
  directions_.resize(units_.size(), {std::vector<double>(size, 0), std::vector<double>(size, 0)});
  crossings_.assign(kCrossingMembers * size, 0);
  marks_.assign(size, 0);
}

void RayBundle::setReference(std::size_t bearing, std::size_t landmark)
{
  reference_x_ = x_[landmark];
  reference_y_ = y_[landmark];
  invertAll(x_.data(), y_.data(), reference_x_, reference_y_, size(), px_.data(), py_.data(), qx_.data(), qy_.data());
  const Vector2d& from = units_[bearing];
  for (std::size_t m = 0; m < units_.size(); ++m)
  {
    const double c = units_[m].dot(from), s = units_[m].y() * from.x() - units_[m].x() * from.y();
    rotateAll(qx_.data(), qy_.data(), c, s, size(), directions_[m].ux.data(), directions_[m].uy.data());
  }
}

void RayBundle::cross(const InverseRay& ray, std::size_t bearing, const CrossingBounds& bounds, const Mask& mask,
                      std::vector<CrossedLandmark>& result)
{
  const CrossingArrays crossings(marks_.data(), crossings_.data(), size());
  const Directions& d = directions_[bearing];
  crossAll(ray, px_.data(), py_.data(), d.ux.data(), d.uy.data(), mask.data(), bounds, size(), crossings);
  result.clear();
  for (std::size_t l = 0; l < size(); ++l)
    if (marks_[l] != 0) result.push_back({l, crossings.at(l)});
}

void RayBundle::openGates(const RayCrossing& crossing, bool covariance, double max_range)
{
  const GateArrays gates{wx_.data(), wy_.data(), narrow_.data(), wide_.data()};
  (covariance ? gatesCovariance : gatesWorstCase)(crossing, error_, px_.data(), py_.data(), size(), gates);
  const double limit = max_range + crossing.slack;
  if (!std::isfinite(limit)) return;
  for (std::size_t l = 0; l < size(); ++l)
    if (std::hypot(x_[l] - reference_x_ - crossing.x, y_[l] - reference_y_ - crossing.y) > limit) closeGate(l);
}

void RayBundle::admit(std::size_t bearing, const Mask& mask, std::vector<std::size_t>& result)
{
  const Directions& d = directions_[bearing];
  const GateArrays gates{wx_.data(), wy_.data(), narrow_.data(), wide_.data()};
  result.clear();
  if (admitAll(gates, d.ux.data(), d.uy.data(), mask.data(), size(), marks_.data()) == 0) return;
  for (std::size_t l = 0; l < size(); ++l)
    if (marks_[l] != 0) result.push_back(l);
}
}  // namespace mrpt_ext
