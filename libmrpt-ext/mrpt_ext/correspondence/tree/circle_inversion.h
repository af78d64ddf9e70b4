#pragma once

#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// The plane of f = 1 / (L - R), complex, for a reference landmark L and the robot R (paper 000, eq 3). In it bearings
/// need no heading and a circle through L is a line: another landmark L_l is the point p = -1 / (L_l - L), and a
/// bearing matched to it, measured against the bearing of L, is a ray from p on which f lies. A pose is where two rays
/// cross.
///
/// All bounds here hold for every pose at which each bearing is within `error` of its measured value, not only to first
/// order: turning ray i by d_i moves the crossing by D = sum_i tan(d_i) (t_i + u_i . D) / t_i G_i exactly, with t_i the
/// distance along the unit vector u_i and G_i the derivative; |d_1|, |d_2| and |d_1 - d_2| are at most 2 `error`.
struct InverseRay
{
  double px = 0, py = 0;  ///< its landmark [1/m]
  double ux = 0, uy = 0;  ///< unit vector; zero for a landmark at the position of the reference
};

/// Bounds common to all crossings with one reference landmark.
struct CrossingBounds
{
  double error = 0;  ///< tan(2 eps) / 2
  /// Tangent of the largest angle between a ray and the direction of the landmark of another that is nearly opposite to
  /// it; negative: not bounded.
  double facing = 0;
  double west = 0, south = 0, east = 0, north = 0;  ///< area of the robot, relative to the reference landmark [m]
};

enum class CrossingOutcome
{
  none,  ///< the rays do not meet, or outside the area, by more than the bearings' error
  open,  ///< nearly parallel rays: robot and landmarks nearly on one circle, no information
  pose
};

struct RayCrossing
{
  CrossingOutcome outcome = CrossingOutcome::open;
  double fx = 0, fy = 0;  ///< f [1/m]
  double ax = 0, ay = 0;  ///< d f / d angle of the first ray [1/m]
  double bx = 0, by = 0;  ///< and of the second
  double shift = 0;       ///< largest distance of the true f [1/m]
  double bend = 0;        ///< largest change beyond first order of the direction from a point to f [rad/m]
  double x = 0, y = 0;    ///< robot relative to the reference landmark [m]
  double slack = 0;       ///< and its largest distance to the true position [m]
};

/// Smallest sine of a crossing, in units of the error: below it the bounds grow too wide to be of use.
inline constexpr double kParallel = 6;

// std::max returns a reference, std::fmax minds NaN: neither becomes vector code.
[[gnu::always_inline]] inline double greater(double a, double b) { return a > b ? a : b; }

/// No branches, so that a loop over rays becomes vector code.
[[gnu::always_inline]] inline RayCrossing crossRays(const InverseRay& a, const InverseRay& b,
                                                    const CrossingBounds& bounds)
{
  RayCrossing c;
  const double wx = b.px - a.px, wy = b.py - a.py;
  const double sine = a.ux * b.uy - a.uy * b.ux, steep = std::abs(sine);
  const double inverse = 1 / sine;
  const double ta = (wx * b.uy - wy * b.ux) * inverse, tb = (wx * a.uy - wy * a.ux) * inverse;
  c.fx = a.px + ta * a.ux;
  c.fy = a.py + ta * a.uy;
  c.ax = ta * inverse * b.ux;
  c.ay = ta * inverse * b.uy;
  c.bx = -tb * inverse * a.ux;
  c.by = -tb * inverse * a.uy;
  // First order: |G_a|, |G_b| or |G_a + G_b| = |w| / sine; the rest of the formula above adds 4 error / sine of itself.
  const double reach2 = greater(greater(ta * ta, tb * tb), wx * wx + wy * wy);
  c.shift = 2 * bounds.error * std::sqrt(reach2) / (steep - 4 * bounds.error);
  c.bend = c.shift * bounds.error * (1 + 4 / steep);

  const double f2 = c.fx * c.fx + c.fy * c.fy, f = std::sqrt(f2);
  c.x = -c.fx / f2;
  c.y = c.fy / f2;
  c.slack = f > c.shift ? c.shift / (f * (f - c.shift)) : std::numeric_limits<double>::infinity();
  const bool open = !(steep > kParallel * bounds.error);
  // Rays that are nearly opposite to each other meet between their landmarks, or not at all.
  const double along_a = a.ux * wx + a.uy * wy, along_b = -b.ux * wx - b.uy * wy;
  const double across_a = std::abs(a.ux * wy - a.uy * wx), across_b = std::abs(b.ux * wy - b.uy * wx);
  const bool aside = (across_a > bounds.facing * along_a) | (across_b > bounds.facing * along_b);
  const bool apart = (bounds.facing > 0) & (a.ux * b.ux + a.uy * b.uy < 0) & aside;
  const bool outside = (c.x < bounds.west - c.slack) | (c.x > bounds.east + c.slack) | (c.y < bounds.south - c.slack) |
                       (c.y > bounds.north + c.slack);
  const bool behind = (ta < -c.shift) | (tb < -c.shift);
  const CrossingOutcome singular = apart ? CrossingOutcome::none : CrossingOutcome::open;
  c.outcome = open ? singular : (outside | behind) ? CrossingOutcome::none : CrossingOutcome::pose;
  return c;
}

/// Gate of the bearing of one landmark, seen from a crossing: a direction passes when
/// |cross(direction, w)| narrow <= wide dot(direction, w), which needs no trigonometry. narrow = wide = 0: any passes.
struct DirectionGate
{
  double wx = 0, wy = 0;  ///< from the landmark to f
  double narrow = 0, wide = 0;

  [[gnu::always_inline]] [[nodiscard]] bool admits(double ux, double uy) const
  {
    return std::abs(ux * wy - uy * wx) * narrow <= wide * (ux * wx + uy * wy);
  }
};

/// With s_i the sensitivity of the bearing to those of the two rays and the reference, the gate is
/// error (1 + sum |s_i|) and what the shift adds, or, with `Covariance`, error (1 + sum s_i^2)^(1/2)
/// (InterpretationGate).
template <bool Covariance>
[[gnu::always_inline]] inline DirectionGate gateAt(const RayCrossing& c, double error, double px, double py)
{
  DirectionGate gate;
  gate.wx = c.fx - px;
  gate.wy = c.fy - py;
  const double r2 = gate.wx * gate.wx + gate.wy * gate.wy, r = std::sqrt(r2), room = r - c.shift;
  const double sa = (gate.wx * c.ay - gate.wy * c.ax) / r2, sb = (gate.wx * c.by - gate.wy * c.bx) / r2;
  const double s0 = 1 - sa - sb;
  const double angle = Covariance ? error * std::sqrt(1 + sa * sa + sb * sb + s0 * s0) * r / room
                                  : error + (error * (std::abs(sa) + std::abs(sb) + std::abs(s0)) * r + c.bend) / room;
  // tan(g) < pi^2 g / (pi^2 - 4 g^2) below a right angle
  const bool anything = !(room > 0.2 * r) | !(angle < 1.5);
  gate.narrow = anything ? 0 : kPi * kPi - 4 * angle * angle;
  gate.wide = anything ? 0 : kPi * kPi * angle;
  return gate;
}
}  // namespace mrpt_ext
