#pragma once

#include <optional>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
// The robot frame of paper 001 has x to the right and y forward; its slope beta is the angle of that x axis in the
// world. Everywhere else forward is x. Convert once, where observations enter.

/// Bearing from forward [rad, wrapped] of a slant (direction angle in the paper's robot frame).
[[nodiscard]] inline double forwardBearingFromSlant(double slant) { return wrap(slant - 0.5 * kPi); }
/// Slant [rad, wrapped] of a bearing from forward.
[[nodiscard]] inline double slantFromForwardBearing(double bearing) { return wrap(bearing + 0.5 * kPi); }
/// Heading [rad, wrapped] of a robot whose x axis (to the right) has the slope beta.
[[nodiscard]] inline double headingFromSlope(double beta) { return wrap(beta + 0.5 * kPi); }
/// Slope beta [rad, wrapped] of the paper for a heading.
[[nodiscard]] inline double slopeFromHeading(double heading) { return wrap(heading - 0.5 * kPi); }
/// Point of the paper's robot frame (right, forward) in our robot frame (forward, left).
[[nodiscard]] inline Vector2d robotFromMovis(const Vector2d& point) { return {point.y(), -point.x()}; }
/// Point of our robot frame (forward, left) in the paper's (right, forward).
[[nodiscard]] inline Vector2d movisFromRobot(const Vector2d& point) { return {-point.y(), point.x()}; }

/// An omnidirectional camera of the triple mirror (paper 001, section 2), in the paper's robot frame.
struct MovisCamera
{
  Vector2d position{0, 0};    ///< [unit of L]
  double position_angle = 0;  ///< gamma [rad], direction robot centre -> camera

  /// Slant of a reading theta, which the paper counts CCW from the direction camera -> robot centre.
  [[nodiscard]] double slantFromTheta(double theta) const { return wrap(theta + position_angle + kPi); }
  [[nodiscard]] double thetaFromSlant(double slant) const { return wrap(slant - position_angle - kPi); }
};

/// Camera `number` at distance L from the robot centre: 1 left front (150 deg), 2 right front (30 deg), 3 rear (-90
/// deg); nothing for other numbers. The paper's eq 1-2 hold with M1 on the left only.
[[nodiscard]] inline std::optional<MovisCamera> movisCamera(int number, double L)
{
  if (number < 1 || number > 3) return std::nullopt;
  constexpr double kAngles[] = {150, 30, -90};
  const double angle = degToRad(kAngles[number - 1]);
  return MovisCamera{{L * std::cos(angle), L * std::sin(angle)}, angle};
}
}  // namespace mrpt_ext
