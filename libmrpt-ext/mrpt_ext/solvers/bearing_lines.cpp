#include "mrpt_ext/solvers/bearing_lines.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
std::vector<BearingLine> bearingLines(std::span<const KnownBearing> bearings)
{
  std::vector<BearingLine> lines;
  lines.reserve(bearings.size());
  for (const KnownBearing& seen : bearings.subspan(1))
  {
    const Vector2d to_landmark = seen.landmark - bearings[0].landmark;
    BearingLine line;
    line.b = Vector2d(to_landmark.x(), -to_landmark.y()) / to_landmark.squaredNorm();
    const Vector2d along = rotation(seen.bearing - bearings[0].bearing) * line.b.normalized();
    line.a = along * line.b.norm();
    line.normal = perpendicular(along);
    line.std = seen.std;
    lines.push_back(line);
  }
  return lines;
}

std::vector<double> rangeRatios(std::span<const BearingLine> lines, const Vector2d& f)
{
  std::vector<double> ratios;
  ratios.reserve(lines.size());
  for (const BearingLine& line : lines) ratios.push_back(line.a.dot(f + line.b) / line.a.squaredNorm());
  return ratios;
}

std::optional<Vector2d> robotFromReference(const Vector2d& f)
{
  const Vector2d robot = Vector2d(-f.x(), f.y()) / f.squaredNorm();
  if (!robot.allFinite()) return std::nullopt;
  return robot;
}
}  // namespace mrpt_ext
