#include "mrpt_ext/correspondence/points/point_fit.h"

#include <algorithm>

#include "mrpt_ext/geometry/work_counter.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostGrown = 12;  // more points hardly improve the fit
// Operations: of a fit and of each of its points, of a point that is looked up on the map.
constexpr std::uint64_t kWorkOfFit = 20, kWorkOfFittedPoint = 3, kWorkOfLookup = 15, kWorkOfCandidate = 5;
}  // namespace

GaussianPose PointFit::pose() const
{
  GaussianPose pose;
  const Vector2d origin = toWorld(Vector2d::Zero());
  pose.mean = {origin.x(), origin.y(), std::atan2(s, c)};
  const Vector2d swing = perpendicular(origin - centre_world);  // how the origin moves with the heading
  pose.covariance.topLeftCorner<2, 2>() =
      position_variance * Matrix2d::Identity() + heading_variance * swing * swing.transpose();
  pose.covariance.topRightCorner<2, 1>() = heading_variance * swing;
  pose.covariance.bottomLeftCorner<1, 2>() = heading_variance * swing.transpose();
  pose.covariance(2, 2) = heading_variance;
  return pose;
}

PointFit fitPoints(std::span<const PointMatch> matches)
{
  PointFit fit;
  const auto n = static_cast<double>(matches.size());
  double variance = 0;
  for (const PointMatch& match : matches)
  {
    fit.centre_robot += match.point->in_robot / n;
    fit.centre_world += match.landmark / n;
    variance = std::max(variance, square(match.point->std));
  }
  double c = 0, s = 0, inertia = 0;
  for (const PointMatch& match : matches)
  {
    const Vector2d p = match.point->in_robot - fit.centre_robot, l = match.landmark - fit.centre_world;
    c += p.dot(l);
    s += cross(p, l);
    inertia += p.squaredNorm();
  }
  const double size = std::hypot(c, s);
  if (size > 0)
  {
    fit.c = c / size;
    fit.s = s / size;
  }
  fit.position_variance = variance / n;
  fit.heading_variance = variance / std::max(inertia, 1e-12);
  return fit;
}

GrownFit growFit(const LandmarkIndex& map, std::span<const PointMatch> constellation, std::span<const ScanPoint> others,
                 double gate, int least)
{
  std::array<PointMatch, kMostGrown> matches;
  std::size_t count = std::min(constellation.size(), kMostGrown);
  std::copy_n(constellation.begin(), count, matches.begin());
  GrownFit grown{fitPoints({matches.data(), count}), static_cast<int>(constellation.size()), kWorkOfFit};
  int left = static_cast<int>(others.size());
  for (const ScanPoint& point : others)
  {
    grown.operations += kWorkOfLookup;
    const Vector2d expected = grown.fit.toWorld(point.in_robot);
    double nearest2 = square(gate) * (square(point.std) + grown.fit.varianceAt(point.in_robot));
    const Vector2d* landmark = nullptr;
    map.forEachNear(expected, std::sqrt(nearest2),
                    [&](std::size_t candidate)
                    {
                      grown.operations += kWorkOfCandidate;
                      const double distance2 = (map.position(candidate) - expected).squaredNorm();
                      if (distance2 > nearest2 || !map.mayShow(point.category, candidate)) return;
                      nearest2 = distance2;
                      landmark = &map.position(candidate);
                    });
    if (landmark)
    {
      ++grown.inliers;
      if (count < kMostGrown)
      {
        matches[count++] = {&point, *landmark};
        grown.fit = fitPoints({matches.data(), count});
        grown.operations += kWorkOfFit + kWorkOfFittedPoint * count;
      }
    }
    if (grown.inliers + --left < least) break;
  }
  WorkCounter::add(grown.operations);
  return grown;
}
}  // namespace mrpt_ext
