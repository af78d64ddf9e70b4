#include "mrpt_ext/solvers/bearing_triple.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
Vector2d times(const Vector2d& a, const Vector2d& b)
{
  return {a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x()};
}
Vector2d conjugate(const Vector2d& a) { return {a.x(), -a.y()}; }
Vector2d reciprocal(const Vector2d& a) { return conjugate(a) / a.squaredNorm(); }
}  // namespace

BearingTriple solveBearingTriple(const std::array<Vector2d, 3>& landmarks, const std::array<Vector2d, 3>& unit_bearings,
                                 double error)
{
  const Vector2d b1 = reciprocal(landmarks[1] - landmarks[0]), b2 = reciprocal(landmarks[2] - landmarks[0]);
  const Vector2d reference = conjugate(unit_bearings[0]);
  const Vector2d a1 = times(times(unit_bearings[1], reference), b1);
  const Vector2d a2 = times(times(unit_bearings[2], reference), b2);

  // f = r1 a1 - b1 = r2 a2 - b2. Three angles decide by their signs: between a1 and a2, and of w against each. Each
  // depends on a difference of two bearings, so outside a margin of twice their error the sign is certain.
  const Vector2d w = b1 - b2;
  const double margin = 2 * error;
  const double sine = cross(a1, a2);
  BearingTriple result;
  const double size2 = a1.squaredNorm() * a2.squaredNorm();
  if (!(size2 > 0) || sine * sine <= square(margin + 1e-12) * size2) return result;
  const double side = sine > 0 ? 1 : -1;
  const double n1 = side * cross(w, a2), n2 = side * cross(w, a1);
  const double w2 = w.squaredNorm();
  const auto clearly_negative = [&](double n, const Vector2d& a)
  { return n <= 0 && n * n >= margin * margin * w2 * a.squaredNorm(); };
  if (clearly_negative(n1, a2) || clearly_negative(n2, a1))
  {
    result.outcome = BearingTriple::Outcome::behind;
    return result;
  }
  if (n1 <= 0 || n2 <= 0) return result;

  const Vector2d f = cross(w, a2) / sine * a1 - b1;
  const double f2 = f.squaredNorm();
  if (!(f2 > 0)) return result;
  const Vector2d to_reference = conjugate(f) / f2;  // L_0 - R = 1/f
  result.outcome = BearingTriple::Outcome::pose;
  result.position = landmarks[0] - to_reference;
  result.phi = angleOf(times(to_reference, reference));
  return result;
}
}  // namespace mrpt_ext
