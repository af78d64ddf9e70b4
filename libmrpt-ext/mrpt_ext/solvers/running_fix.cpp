#include "mrpt_ext/solvers/running_fix.h"

#include <algorithm>

#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
namespace
{
/// Standard deviation of the first range, with the error of the displacement, about the second position.
double firstStd(const RangePair& in, const Vector2d& unit)
{
  return std::sqrt(square(in.first_std) + std::max(0.0, unit.dot(in.displacement_covariance * unit)));
}

/// Covariance of the positions that two nearly tangent circles allow, about `point`.
Matrix2d tangentCovariance(const RangePair& in, const TwoCircles& circles, const Vector2d& point)
{
  const Vector2d across = (point - in.landmark).normalized();  // along the line of centres, near a tangent point
  const Vector2d along = perpendicular(across);
  const double noise = std::hypot(firstStd(in, across), in.second_std);
  const bool outer = circles.relation == CircleRelation::separate ||
                     in.displacement.norm() > std::max(in.first_range, in.second_range);
  const double curvature = std::abs((outer ? 1 : -1) / in.first_range + 1 / in.second_range);
  const double largest = std::max(in.first_range, in.second_range);
  const double reach2 = square(largest);  // no further along the tangent than the landmark is away
  const double spread2 = curvature > 0 ? std::min(2 * (circles.gap + noise) / curvature, reach2) : reach2;
  const double width2 = square(noise) + square(0.5 * circles.gap);
  return width2 * across * across.transpose() + (spread2 + width2) * along * along.transpose();
}

std::optional<Matrix2d> linearCovariance(const RangePair& in, const Vector2d& point)
{
  const Vector2d from_virtual = point - in.displacement - in.landmark, from_landmark = point - in.landmark;
  if (!(from_virtual.norm() > 0 && from_landmark.norm() > 0)) return std::nullopt;
  const Vector2d u1 = from_virtual.normalized(), u2 = from_landmark.normalized();
  const double s1 = firstStd(in, u1), s2 = in.second_std;
  if (!(s1 > 0 && s2 > 0)) return Matrix2d(Matrix2d::Zero());  // exact ranges
  return covarianceFromInformation(Matrix2d(u1 * u1.transpose() / square(s1) + u2 * u2.transpose() / square(s2)));
}

RunningFixCandidate candidateAt(const RangePair& in, const TwoCircles& circles, const Vector2d& point)
{
  RunningFixCandidate candidate;
  candidate.second.mean = point;
  candidate.first = point - in.displacement;
  const std::optional<Matrix2d> linear = linearCovariance(in, point);
  const Matrix2d spread = tangentCovariance(in, circles, point);
  candidate.linearised = circles.relation == CircleRelation::two && linear && linear->trace() <= 2 * spread.trace();
  candidate.second.covariance = candidate.linearised ? *linear : spread;
  return candidate;
}

SolveStatus statusOf(CircleRelation relation)
{
  switch (relation)
  {
    case CircleRelation::two:
    case CircleRelation::tangent:
    case CircleRelation::separate:
    case CircleRelation::contained:
      return SolveStatus::ok;
    case CircleRelation::concentric:
      return SolveStatus::none;
    case CircleRelation::coincident:
      return SolveStatus::degenerate;
    case CircleRelation::negative_radius:
    case CircleRelation::not_finite:
      return SolveStatus::bad_input;
  }
  return SolveStatus::bad_input;
}
}  // namespace

RunningFix runningFix(const RangePair& ranges)
{
  RunningFix result;
  const bool noise_ok = ranges.first_std >= 0 && ranges.second_std >= 0 && std::isfinite(ranges.first_std) &&
                        std::isfinite(ranges.second_std) && ranges.displacement_covariance.allFinite();
  if (!noise_ok) return result;
  const TwoCircles circles = intersectCircles({ranges.landmark + ranges.displacement, ranges.first_range},
                                              {ranges.landmark, ranges.second_range});
  result.relation = circles.relation;
  result.status = statusOf(circles.relation);
  if (result.status != SolveStatus::ok) return result;
  result.intersects = circles.count > 0;
  result.gap = circles.gap;
  for (const Vector2d& point : circles.candidates()) result.candidates.push_back(candidateAt(ranges, circles, point));
  return result;
}
}  // namespace mrpt_ext
