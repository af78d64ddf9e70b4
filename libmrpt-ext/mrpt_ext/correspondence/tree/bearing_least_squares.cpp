#include "mrpt_ext/correspondence/tree/bearing_least_squares.h"

#include <algorithm>
#include <vector>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
namespace
{
constexpr int kIterations = 30;
constexpr double kRelativeStep = 1e-4;
constexpr double kNear = 0.1;  // [rad] near it other bearings change by so much

/// Predicted minus measured [rad]; `heading` is the unit vector of the pose's.
double bearingResidual(const MatchedBearing& m, const Vector2d& heading, const Vector2d& to_landmark)
{
  const Vector2d seen = PoseResiduals::turned(m.unit, heading);
  return smallAngle(cross(seen, to_landmark), seen.dot(to_landmark));
}

/// measurement_jacobian.h without a sensor offset.
NormalEquations<3> normalEquations(std::span<const MatchedBearing> matched, const Pose2& pose)
{
  PoseResiduals::countRound(matched.size());
  NormalEquations<3> result;
  const Vector2d position = pose.position(), heading = direction(pose.phi);
  for (const MatchedBearing& m : matched)
  {
    const Vector2d d = m.landmark - position;
    const double e = bearingResidual(m, heading, d), inverse = 1 / d.squaredNorm();
    const JacobianRow row(d.y() * inverse, -d.x() * inverse, -1);
    result.hessian.noalias() += row.transpose() * row;
    result.gradient += e * row.transpose();
    result.cost += e * e;
  }
  return result;
}
}  // namespace

BearingFit fitBearings(std::span<const MatchedBearing> matched, const Pose2& start)
{
  BearingFit fit{.pose = start};
  DescentOptions options;
  options.max_iterations = kIterations;
  options.relative_step = kRelativeStep;
  NormalEquations<3> now = normalEquations(matched, start);
  const auto improved = [&](const Pose2& next, double bound) -> std::optional<NormalEquations<3>>
  {
    NormalEquations<3> there = normalEquations(matched, next);
    if (!(there.cost < bound)) return std::nullopt;
    return there;
  };
  const auto moved = [](const Pose2& p, const Vector3d& step) {
    return Pose2{p.x + step.x(), p.y + step.y(), p.phi + step.z()};
  };
  descendFrom<3>(fit.pose, now, improved, moved, options);
  const Vector2d heading = direction(fit.pose.phi);
  for (const MatchedBearing& m : matched)
    fit.max_residual =
        std::max(fit.max_residual, std::abs(bearingResidual(m, heading, m.landmark - fit.pose.position())));
  return fit;
}

std::optional<Pose2> startNearLandmark(std::span<const MatchedBearing> matched, std::size_t close,
                                       const Vector2d& about, double reach, double error)
{
  const MatchedBearing& at = matched[close];
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < matched.size(); ++i)
    if (i != close) next = std::min(next, (matched[i].landmark - at.landmark).norm());
  if ((at.landmark - about).norm() > reach + kNear * next) return std::nullopt;

  std::vector<MatchedBearing> others(matched.begin(), matched.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(close));
  // Each of the others implies a heading.
  const auto heading_of = [&](const MatchedBearing& m) { return angleOf(m.landmark - at.landmark) - m.bearing; };
  const double first = heading_of(others.front());
  double least = 0, most = 0;
  for (const MatchedBearing& m : others)
  {
    const double turn = wrap(heading_of(m) - first);
    least = std::min(least, turn);
    most = std::max(most, turn);
    if (most - least > 2 * (error + kNear)) return std::nullopt;
  }
  Pose2 pose = fitBearings(others, {at.landmark.x(), at.landmark.y(), first + (least + most) / 2}).pose;
  const Vector2d ray = direction(pose.phi + at.bearing);
  const double distance = std::max((at.landmark - pose.position()).dot(ray), kClosestApproach * next);
  const Vector2d position = at.landmark - distance * ray;
  return Pose2{position.x(), position.y(), pose.phi};
}
}  // namespace mrpt_ext
