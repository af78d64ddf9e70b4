#pragma once

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

// Formulas of the papers as printed, mistakes included: for the proofs that they are mistakes, and nothing else.
namespace mrpt_ext::papers::printed
{
using Complex = std::complex<double>;

inline Complex complex(const Vector2d& v) { return {v.x(), v.y()}; }

/// Paper 000, eq 1-5: the position from bearings that are taken against `reference` (print: theta_b; right: the bearing
/// of landmark 0).
inline Vector2d bearingPosition(const std::vector<Vector2d>& landmarks, const std::vector<double>& bearings,
                                double reference)
{
  Matrix2d S = Matrix2d::Zero();
  Vector2d v = Vector2d::Zero();
  for (std::size_t i = 1; i < landmarks.size(); ++i)
  {
    const Complex to_reference = complex(landmarks[i] - landmarks[0]);
    const Complex a = std::polar(1.0, bearings[i] - reference) / to_reference, b = 1.0 / to_reference;
    const Vector2d n = Vector2d(-a.imag(), a.real()).normalized();
    S += n * n.transpose();
    v += n * n.dot(Vector2d(b.real(), b.imag()));
  }
  const Vector2d f = -S.inverse() * v;
  return landmarks[0] - Vector2d(f.x(), -f.y()) / f.squaredNorm();
}

/// Paper 000, eq 6: the heading with tan^-1.
inline double bearingHeading(const Vector2d& landmark, const Vector2d& robot, double bearing)
{
  const Vector2d d = landmark - robot;
  return std::atan(d.y() / d.x()) - bearing;
}

/// Paper 000, eq 18: the ratio r_1 with (a_1^T a)^-1, `a` being another vector than a_1.
inline double rangeRatio(const Vector2d& a_1, const Vector2d& a, const Vector2d& f, const Vector2d& b_1)
{
  return a_1.dot(f + b_1) / a_1.dot(a);
}

/// Paper 001, eq 1-2, by tangents: where the slants of the left and the right front camera meet.
inline Vector2d triangulated(double left_slant, double right_slant, double L)
{
  const double t1 = std::tan(left_slant), t2 = std::tan(right_slant), s = std::sqrt(3.0);
  return {s / 2 * L * (t2 + t1) / (t2 - t1), L / 2 + s * L * t1 * t2 / (t2 - t1)};
}

/// Paper 001, eq 5: the slope with tan^-1.
inline double slope(const Vector2d& p, const Vector2d& q) { return std::atan((p.y() - q.y()) / (q.x() - p.x())); }

/// Paper 001, eq 6-7: (X_r, Y_r) from pole p with the signs that belong to q.
inline Vector2d turnedPosition(const Vector2d& p, double beta, double half_width, double depth)
{
  const double c = std::cos(beta), s = std::sin(beta);
  return {-p.x() + c * half_width + s * depth, -p.y() - s * half_width + c * depth};
}

/// Paper 004, eq 4: the first intersection of circles about c1 and c2, by x = A + B y.
inline Vector2d intersection(const Vector2d& c1, double r1, const Vector2d& c2, double r2, double sign)
{
  const double dx = c2.x() - c1.x();
  const double A = (r1 * r1 - r2 * r2 + c2.squaredNorm() - c1.squaredNorm()) / (2 * dx);
  const double B = -(c2.y() - c1.y()) / dx;
  const double a = 1 + B * B, b = 2 * (B * (A - c1.x()) - c1.y());
  const double c = (A - c1.x()) * (A - c1.x()) + c1.y() * c1.y() - r1 * r1;
  const double y = (-b + sign * std::sqrt(b * b - 4 * a * c)) / (2 * a);
  return {A + B * y, y};
}

/// Paper 004, eq 7: the heading with arctan.
inline double fixHeading(const Vector2d& landmark, const Vector2d& robot, const Vector2d& in_robot)
{
  const Vector2d d = landmark - robot;
  return std::atan(d.y() / d.x()) - std::atan(in_robot.y() / in_robot.x());
}

/// Paper 004, eq 8, for the blue goal (landmark at x = 0, robot at x > 0).
inline double blueGoalHeading(const Vector2d& landmark, const Vector2d& robot, const Vector2d& in_robot)
{
  return M_PI - (std::atan((landmark.y() - robot.y()) / robot.x()) + std::atan(in_robot.y() / in_robot.x()));
}
}  // namespace mrpt_ext::papers::printed
