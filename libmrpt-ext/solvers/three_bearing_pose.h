#pragma once

#include <cmath>
#include <limits>

namespace mrpt_ext
{
/// A known landmark [m, world frame] and the unit vector of its bearing (cos b, sin b), robot frame.
template <class Real>
struct SightedLandmark
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

/// Where three circles of equal inscribed angle meet.
template <class Real>
struct ThreeCircleMeeting
{
  Real qx, qy;            ///< relative to landmark 2 [m]; meaningless when not firm
  bool firm;              ///< the rounding of the bearings cannot have made it up
  Real ahead12, ahead23;  ///< positive when both bearings of the pair, or neither, point at their landmarks
};

/// Pierlot, Van Droogenbroeck, ToTal (IEEE T-RO 30(3), 2014), the robot as the radical centre of three circles.
/// Deviation: each cotangent is kept as cosine over sine and the sines are multiplied out, so that neither trigonometry
/// nor a special case is left: opposite or equal bearings are bearings like any other. With A, B, C the centres times
/// their sines, the determinant is D = S31 A x B + S12 B x C + S23 C x A. Bearings known to eps move it by no more than
/// eps (|A||B| + |B||C| + |C||A|) <= 2.5 eps (|L1 - L2|^2 + |L3 - L2|^2); below 32 times that it says nothing.
template <class Real>
[[gnu::always_inline]] inline ThreeCircleMeeting<Real> meetThreeCircles(const SightedLandmark<Real>& first,
                                                                        const SightedLandmark<Real>& second,
                                                                        const SightedLandmark<Real>& third)
{
  const Real x1 = first.x - second.x, y1 = first.y - second.y;
  const Real x3 = third.x - second.x, y3 = third.y - second.y;
  const Real c12 = first.c * second.c + first.s * second.s, s12 = first.c * second.s - first.s * second.c;
  const Real c23 = second.c * third.c + second.s * third.s, s23 = second.c * third.s - second.s * third.c;
  const Real c31 = s12 * s23 - c12 * c23, s31 = c12 * s23 + c23 * s12;

  const Real ax = s12 * x1 + c12 * y1, ay = s12 * y1 - c12 * x1;
  const Real bx = s23 * x3 - c23 * y3, by = s23 * y3 + c23 * x3;
  const Real cx = s31 * (x3 + x1) + c31 * (y3 - y1), cy = s31 * (y3 + y1) - c31 * (x3 - x1);
  const Real k = s31 * (x1 * x3 + y1 * y3) + c31 * (x1 * y3 - x3 * y1);
  const Real dx = s23 * ax - s12 * bx, dy = s23 * ay - s12 * by;
  const Real determinant = s31 * (ax * by - ay * bx) - (dx * cy - dy * cx);

  const Real noise = 80 * std::numeric_limits<Real>::epsilon() * (x1 * x1 + y1 * y1 + x3 * x3 + y3 * y3);
  const Real factor = k / determinant;
  const Real qx = factor * dy, qy = -factor * dx;
  const Real q2 = qx * qx + qy * qy;
  return {qx, qy, std::abs(determinant) > noise, c12 * (q2 - (qx * x1 + qy * y1)) + s12 * (qx * y1 - qy * x1),
          c23 * (q2 - (qx * x3 + qy * y3)) - s23 * (qx * y3 - qy * x3)};
}

/// The pose from which three known landmarks are seen under three directed bearings; there is at most one. No
/// trigonometry, one square root; never NaN. Only differences of landmarks enter, the vectors must have length one.
template <class Real>
[[gnu::always_inline]] inline ThreeBearingPose<Real> solveThreeBearingPose(const SightedLandmark<Real>& first,
                                                                           const SightedLandmark<Real>& second,
                                                                           const SightedLandmark<Real>& third)
{
  const ThreeCircleMeeting<Real> at = meetThreeCircles(first, second, third);
  ThreeBearingPose<Real> result;
  if (!at.firm) return result;
  if (at.ahead12 > 0 && at.ahead23 > 0)
  {
    const Real vx = first.x - second.x - at.qx, vy = first.y - second.y - at.qy;
    const Real length2 = vx * vx + vy * vy;
    if (!(length2 > 0 && length2 < std::numeric_limits<Real>::infinity())) return result;
    const Real inverse = 1 / std::sqrt(length2);
    result.outcome = ThreeBearingOutcome::pose;
    result.x = second.x + at.qx;
    result.y = second.y + at.qy;
    result.c = (vx * first.c + vy * first.s) * inverse;
    result.s = (vy * first.c - vx * first.s) * inverse;
  }
  else if (at.ahead12 < 0 || at.ahead23 < 0)
    result.outcome = ThreeBearingOutcome::behind;
  return result;
}
}  // namespace mrpt_ext
