#include "mrpt_ext/solvers/known_bearing.h"

#include <algorithm>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
bool isUsableBearing(const KnownBearing& b)
{
  return b.landmark.allFinite() && std::isfinite(b.bearing) && std::isfinite(b.std) && b.std > 0;
}
}  // namespace

SolveStatus checkBearings(std::span<const KnownBearing> bearings)
{
  if (!std::all_of(bearings.begin(), bearings.end(), isUsableBearing)) return SolveStatus::bad_input;
  if (bearings.size() < 3) return SolveStatus::too_few;
  double extent = 0;
  for (const KnownBearing& b : bearings) extent = std::max(extent, (b.landmark - bearings[0].landmark).norm());
  const auto on_reference = [&](const KnownBearing& b)
  { return (b.landmark - bearings[0].landmark).norm() <= 1e-12 * extent; };
  return std::any_of(bearings.begin() + 1, bearings.end(), on_reference) ? SolveStatus::degenerate : SolveStatus::ok;
}

Vector2d landmarkMean(std::span<const KnownBearing> bearings)
{
  Vector2d sum = Vector2d::Zero();
  for (const KnownBearing& b : bearings) sum += b.landmark;
  return bearings.empty() ? sum : Vector2d(sum / static_cast<double>(bearings.size()));
}

double meanHeading(std::span<const KnownBearing> bearings, const Vector2d& position)
{
  Vector2d sum = Vector2d::Zero();
  for (const KnownBearing& b : bearings) sum += direction(angleOf(b.landmark - position) - b.bearing) / square(b.std);
  return angleOf(sum);
}

std::vector<double> bearingResiduals(std::span<const KnownBearing> bearings, const Pose2& pose)
{
  std::vector<double> residuals;
  residuals.reserve(bearings.size());
  for (const KnownBearing& b : bearings) residuals.push_back(wrap(predictBearing(pose, b.landmark) - b.bearing));
  return residuals;
}
}  // namespace mrpt_ext
