#pragma once

#include <cmath>
#include <limits>

namespace mrpt_ext
{
/// A known landmark [m, world frame] and the unit vector of its bearing (cos b, sin b), robot frame.
template <class Real>
struct VisibleLandmark
{
  Real x, y;
  Real c, s;
};

enum class ThreeBearingOutcome
{
  pose,       ///< exactly one pose
  behind,     ///< the lines of sight meet, but a landmark would lie behind its bearing
  degenerate  ///< robot and landmarks on one circle or line, within rounding; or input that is not finite
};

template <class Real>
struct ThreeBearingPose
{
  ThreeBearingOutcome outcome = ThreeBearingOutcome::degenerate;
  Real x = 0, y = 0;  ///< [m], world frame; 0 without a pose
  Real c = 1, s = 0;  ///< cosine and sine of the heading; 1 and 0 without a pose
};

/// The two linear equations that two landmarks leave beside the first one, solved up to a common scale.
template <class Real>
struct ThreeBearingSolution
{
  Real nx, ny;          ///< n = scale exp(-j heading)
  Real d;               ///< scale times the distance of the first landmark; carries the sign of the scale
  Real n2;              ///< |n|^2
  Real along1, along2;  ///< scale times the distances of the others
  bool firm;            ///< the rounding of the bearings cannot have made it up, and everything is finite

  /// No landmark lies behind its bearing.
  [[gnu::always_inline]] [[nodiscard]] bool ahead() const { return (along1 * d > 0) & (along2 * d > 0); }
};

/// Paper 000, eq 3, with the unknown f multiplied by the unit vector of the reference bearing: with u_i the bearings,
/// L_i - R = r_i e^(j phi) u_i, k = e^(-j phi) / r_0 and v_i = L_i - L_0 it reads Im(conj(u_i) v_i k) = cross(u_0,
/// u_i), i = 1, 2. Kept as the cross product (n, d) of the two rows, k = n / d, it needs neither trigonometry nor a
/// special case for opposite or equal bearings, and holds the heading already. (n, d) vanishes when all are on one
/// circle. Bearings known to eps move n by no more than 2 eps (|v_1| + |v_2|); below 32 times that it says nothing.
template <class Real>
[[gnu::always_inline]] inline ThreeBearingSolution<Real> solveThreeBearings(const VisibleLandmark<Real>& first,
                                                                            const VisibleLandmark<Real>& second,
                                                                            const VisibleLandmark<Real>& third)
{
  const Real x1 = second.x - first.x, y1 = second.y - first.y;
  const Real x2 = third.x - first.x, y2 = third.y - first.y;
  const Real p1 = second.c * x1 + second.s * y1, q1 = second.c * y1 - second.s * x1;  // conj(u) v = p + j q
  const Real p2 = third.c * x2 + third.s * y2, q2 = third.c * y2 - third.s * x2;
  const Real s1 = first.c * second.s - first.s * second.c, s2 = first.c * third.s - first.s * third.c;
  const Real c1 = first.c * second.c + first.s * second.s, c2 = first.c * third.c + first.s * third.s;

  ThreeBearingSolution<Real> result;
  const Real nx = s1 * p2 - s2 * p1, ny = q1 * s2 - q2 * s1, d = q1 * p2 - q2 * p1;
  result.nx = nx;
  result.ny = ny;
  result.d = d;
  result.n2 = nx * nx + ny * ny;
  result.along1 = p1 * nx - q1 * ny + c1 * d;
  result.along2 = p2 * nx - q2 * ny + c2 * d;
  constexpr Real kNoise = 64 * std::numeric_limits<Real>::epsilon();
  const Real size2 = p1 * p1 + q1 * q1 + p2 * p2 + q2 * q2;
  const Real noise2 = 2 * kNoise * kNoise * size2 + std::numeric_limits<Real>::min();
  result.firm = (result.n2 > noise2) & (result.n2 < std::numeric_limits<Real>::infinity());
  return result;
}

/// The pose from which three known landmarks are seen under three directed bearings; there is at most one. No
/// trigonometry, one square root; never NaN. Only differences of landmarks enter, the vectors must have length one.
template <class Real>
[[gnu::always_inline]] inline ThreeBearingPose<Real> solveThreeBearingPose(const VisibleLandmark<Real>& first,
                                                                           const VisibleLandmark<Real>& second,
                                                                           const VisibleLandmark<Real>& third)
{
  const ThreeBearingSolution<Real> at = solveThreeBearings(first, second, third);
  ThreeBearingPose<Real> result;
  if (!at.firm) return result;
  if (at.ahead())
  {
    // The root of n2 does not wait for the division.
    const Real inverse = 1 / at.n2, factor = at.d * inverse, turn = std::copysign(std::sqrt(at.n2) * inverse, at.d);
    result.outcome = ThreeBearingOutcome::pose;
    result.x = first.x - factor * (at.nx * first.c + at.ny * first.s);  // L_0 - R = u_0 / k
    result.y = first.y - factor * (at.nx * first.s - at.ny * first.c);
    result.c = turn * at.nx;
    result.s = -turn * at.ny;
  }
  else if (at.along1 * at.d < 0 || at.along2 * at.d < 0)
    result.outcome = ThreeBearingOutcome::behind;
  return result;
}
}  // namespace mrpt_ext
