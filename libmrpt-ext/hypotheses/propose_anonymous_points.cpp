#include <algorithm>

#include "mrpt_ext/hypotheses/pose_proposals.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = 3.5;         // standard deviations of a distance
constexpr std::size_t kMaxPairs = 6;  // pairs of sightings tried, the widest: they fix the heading best
constexpr std::size_t kMaxSolutions = 2000;

struct SightingPair
{
  std::size_t i = 0, j = 0;
  double distance = 0;
  double std = 0;
};

std::vector<SightingPair> widestPairs(const std::vector<LandmarkSighting>& points)
{
  std::vector<SightingPair> pairs;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      const double std = std::sqrt(points[i].pointCovariance().trace() + points[j].pointCovariance().trace());
      pairs.push_back({i, j, (points[i].pointInRobot() - points[j].pointInRobot()).norm(), std});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.distance > b.distance; });
  if (pairs.size() > kMaxPairs) pairs.resize(kMaxPairs);
  return pairs;
}

bool fits(const LandmarkSighting& sighting, const Landmark& landmark)
{
  return sighting.category.empty() || sighting.category == landmark.category;
}
}  // namespace

HypothesisSet proposeFromAnonymousPoints(std::span<const LandmarkSighting> sightings, const LandmarkTable& map)
{
  std::vector<LandmarkSighting> points;
  std::copy_if(sightings.begin(), sightings.end(), std::back_inserter(points),
               [](const LandmarkSighting& s) { return s.hasPoint(); });
  HypothesisSet result;
  for (const SightingPair& pair : widestPairs(points))
  {
    const LandmarkSighting &first = points[pair.i], &second = points[pair.j];
    const GaussianPoint first_point{first.pointInRobot(), first.pointCovariance()};
    const GaussianPoint second_point{second.pointInRobot(), second.pointCovariance()};
    for (std::size_t a = 0; a < map.size(); ++a)
      for (std::size_t b = 0; b < map.size(); ++b)
      {
        if (a == b || !fits(first, map[a]) || !fits(second, map[b])) continue;
        const Vector2d at_a = map[a].position.head<2>(), at_b = map[b].position.head<2>();
        if (std::abs((at_a - at_b).norm() - pair.distance) > kGate * pair.std) continue;
        const std::array seen{SeenLandmark{at_a, first_point}, SeenLandmark{at_b, second_point}};
        const PointPose fit = solvePointPose(seen);
        if (fit.status == SolveStatus::ok) result.push_back({.pose = fit.pose, .source = "two_landmark_pose"});
        if (result.size() >= kMaxSolutions) return result;
      }
  }
  return result;
}
}  // namespace mrpt_ext
