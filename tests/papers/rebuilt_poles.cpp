#include "rebuilt_poles.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "mrpt_ext/solvers/plane.h"
#include "printed_rows.h"

namespace mrpt_ext::papers
{
namespace
{
constexpr int kFactorSteps = 20;
constexpr double kSmallFactor = 1e-5;  ///< for derivatives
constexpr double kLeftFactorFrom = 0.6, kLeftFactorTo = 1.2, kLeftFactorStep = 5e-4;

Vector2d towards(double slope) { return {std::cos(slope), -std::sin(slope)}; }  // from p to q, in the robot's frame

/// The slope after eq 8: by the angle of the object in table 4, or by its X alone where Y is a misprint.
double slopeOfTableFour(const PrintedPoint& row, bool misprinted)
{
  const Vector2d sum = inMetres(row.object_in_robot) + inMetres(row.after), object = inMetres(row.object_in_field);
  if (!misprinted) return wrap(angleOf(object) - angleOf(sum));
  return wrap(std::acos(object.x() / sum.norm()) - angleOf(sum));  // the object is ahead
}

/// By how much the right pole, with factors `f`, is too far in table 2 for any slope [m].
double rightPoleMisfit(const Vector2d& q_after, const PrintedPoint& row, const Vector2d& f, const MovisLattice& lattice)
{
  return (inMetres(row.before) + q_after.cwiseQuotient(f)).norm() - lattice.poleQ().norm();
}

bool isMisprinted(const MovisLattice& lattice, std::size_t point)
{
  return std::string(kMisprintedAt).find(lattice.names[point]) != std::string::npos;
}

/// Least squares over the points without a misprint, by Gauss and Newton.
Vector2d rightPoleFactors(const std::vector<Vector2d>& q_after, const MovisLattice& lattice)
{
  Vector2d factors(1, 1);
  for (int step = 0; step < kFactorSteps; ++step)
  {
    Matrix2d normal = Matrix2d::Zero();
    Vector2d right_side = Vector2d::Zero();
    for (std::size_t i = 0; i < q_after.size(); ++i)
    {
      if (isMisprinted(lattice, i)) continue;
      const auto misfit = [&](const Vector2d& f) { return rightPoleMisfit(q_after[i], kPrintedPoints[i], f, lattice); };
      const double here = misfit(factors);
      const Vector2d slope((misfit(factors + Vector2d(kSmallFactor, 0)) - here) / kSmallFactor,
                           (misfit(factors + Vector2d(0, kSmallFactor)) - here) / kSmallFactor);
      normal += slope * slope.transpose();
      right_side -= here * slope;
    }
    factors += normal.inverse() * right_side;
  }
  return factors;
}

/// Left poles for one factor of X; that of Y is set by the origin, where eq 8 makes the pole exact.
void addLeftPoles(RebuiltLattice& lattice_seen, double x_factor, const std::vector<Vector2d>& q_after,
                  const MovisLattice& lattice)
{
  std::vector<RebuiltPoint>& points = lattice_seen.points;
  RebuiltPoint& origin = points[lattice.origin];
  const Vector2d line = towards(origin.slope_before);
  origin.p = origin.q - (origin.q.x() - lattice.poleP().x() / x_factor) / line.x() * line;
  const Vector2d factors(x_factor, lattice.poleP().y() / origin.p.y());
  lattice_seen.correction.p_factor = factors;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i == lattice.origin) continue;
    // Where the line before eq 8, scaled by the factors, meets the one after it.
    const Vector2d before = towards(points[i].slope_before);
    Matrix2d lines;
    lines << -factors.cwiseProduct(before), towards(points[i].slope_after);
    const Vector2d along = lines.inverse() * (q_after[i] - factors.cwiseProduct(points[i].q));
    points[i].p = points[i].q - along.x() * before;
  }
}

double leftPoleTurns(const RebuiltLattice& seen, const MovisLattice& lattice)
{
  double sum = 0;
  for (std::size_t i = 0; i < seen.points.size(); ++i)
    if (i != lattice.origin) sum += square(turnOf(seen.points[i].p, lattice.poleP(), lattice.places[i]));
  return sum;
}
}  // namespace

double turnOf(const Vector2d& seen, const Vector2d& thing, const Vector2d& place)
{
  return wrap(angleOf(seen) - angleOf(thing - place));
}

MovisLook RebuiltLattice::lookAt(const MovisLattice& lattice, std::size_t point) const
{
  const std::array<Vector2d, 3> things{points[point].p, points[point].q,
                                       inMetres(kPrintedPoints[point].object_in_robot)};
  MovisLook look;
  for (std::size_t thing = 0; thing < things.size(); ++thing)
    for (std::size_t k = 0; k < 2; ++k) look.slant[thing][k] = angleOf(things[thing] - lattice.camera(k).position);
  return look;
}

RebuiltLattice rebuiltFromPrint(const MovisLattice& lattice)
{
  RebuiltLattice seen;
  seen.correction.status = SolveStatus::ok;
  std::vector<Vector2d> q_after;
  for (std::size_t i = 0; i < kPrintedPoints.size(); ++i)
  {
    RebuiltPoint point;
    point.slope_after = slopeOfTableFour(kPrintedPoints[i], isMisprinted(lattice, i));
    q_after.push_back(rotation(-point.slope_after) * lattice.poleQ() - inMetres(kPrintedPoints[i].after));
    seen.points.push_back(point);
  }
  const Vector2d factors = rightPoleFactors(q_after, lattice);
  seen.correction.q_factor = factors;
  for (std::size_t i = 0; i < kPrintedPoints.size(); ++i)
  {
    RebuiltPoint& point = seen.points[i];
    point.q = q_after[i].cwiseQuotient(factors);
    point.slope_before = wrap(angleOf(lattice.poleQ()) - angleOf(inMetres(kPrintedPoints[i].before) + point.q));
    point.misfit = rightPoleMisfit(q_after[i], kPrintedPoints[i], factors, lattice);
  }
  double best = kLeftFactorFrom, least = std::numeric_limits<double>::infinity();
  for (double factor = kLeftFactorFrom; factor <= kLeftFactorTo; factor += kLeftFactorStep)
  {
    addLeftPoles(seen, factor, q_after, lattice);
    if (const double turns = leftPoleTurns(seen, lattice); turns < least) least = turns, best = factor;
  }
  addLeftPoles(seen, best, q_after, lattice);
  return seen;
}
}  // namespace mrpt_ext::papers
