#include "limit/plain_bearing_search.h"

#include <algorithm>
#include <array>
#include <vector>

namespace mrpt_ext::plain
{
namespace
{
constexpr double kShare = 0.75;  // of the bearings that must be inliers of a pose
constexpr double kMinGap = 0.2, kMaxGap = 1.04;
constexpr std::size_t kRounds = 12;

struct Candidate
{
  Vector2d position;
  Vector2d forward;  // the sensor's forward axis
};

struct Search
{
  const LandmarkIndex& map;
  std::vector<double> bearings;  // ascending
  std::vector<Vector2d> rays;
  double range = 0, tolerance = 0;
  int needed = 0;

  [[nodiscard]] bool isInlier(const Candidate& c, std::size_t ray, const std::vector<Vector2d>& around) const
  {
    const Vector2d direction(c.forward.x() * rays[ray].x() - c.forward.y() * rays[ray].y(),
                             c.forward.y() * rays[ray].x() + c.forward.x() * rays[ray].y());
    return std::any_of(around.begin(), around.end(),
                       [&](const Vector2d& landmark)
                       {
                         const Vector2d d = landmark - c.position;
                         const double along = direction.dot(d), across = direction.x() * d.y() - direction.y() * d.x();
                         return along > 0 && std::abs(across) <= tolerance * along && d.norm() <= range;
                       });
  }

  [[nodiscard]] bool acceptable(const Candidate& c, const std::array<std::size_t, 3>& triple,
                                std::vector<Vector2d>& around) const
  {
    around.clear();
    map.forEachNear(c.position, range, [&](std::size_t l) { around.push_back(map.position(l)); });
    int hits = 3, tested = 0;
    for (std::size_t ray = 0; ray < rays.size(); ++ray)
    {
      if (std::find(triple.begin(), triple.end(), ray) != triple.end()) continue;
      hits += isInlier(c, ray, around);
      if (++tested == 2 && hits == 3) return false;
    }
    return hits >= needed;
  }

  [[nodiscard]] std::optional<Pose2> tryTriple(const std::array<std::size_t, 3>& triple) const
  {
    const auto [a, b, c] = triple;
    const double cot_a = 1 / std::tan(bearings[b] - bearings[a]), cot_c = 1 / std::tan(bearings[c] - bearings[b]);
    std::vector<Vector2d> near, around;
    for (const Vector2d& middle : map.positions())
    {
      near.clear();
      map.forEachNear(middle, range, [&](std::size_t l) { near.emplace_back(map.position(l) - middle); });
      for (const Vector2d& j : near)
        for (const Vector2d& k : near)
        {
          const Vector2d u = 0.5 * (j + cot_a * Vector2d(j.y(), -j.x()));
          const Vector2d v = 0.5 * (k + cot_c * Vector2d(-k.y(), k.x()));
          const Vector2d e = v - u;
          const double length2 = e.squaredNorm();
          if (!(length2 > 1e-12)) continue;
          const double t = 2 * (u.x() * e.y() - u.y() * e.x()) / length2;
          const Vector2d p(t * e.y(), -t * e.x());
          const double distance = p.norm();
          if (!(distance > 1e-3) || distance > range || (j - p).norm() > range || (k - p).norm() > range) continue;
          if (p.x() * (j - p).y() - p.y() * (j - p).x() <= 0 || p.x() * (k - p).y() - p.y() * (k - p).x() >= 0)
            continue;
          const Vector2d to_middle = -p / distance;
          const Candidate candidate{
              middle + p, {to_middle.dot(rays[b]), to_middle.y() * rays[b].x() - to_middle.x() * rays[b].y()}};
          if (acceptable(candidate, triple, around))
            return Pose2{candidate.position.x(), candidate.position.y(),
                         std::atan2(candidate.forward.y(), candidate.forward.x())};
        }
    }
    return std::nullopt;
  }
};
}  // namespace

std::optional<Pose2> searchBearings(const LandmarkIndex& map, const Scan& scan)
{
  Search search{map, {}, {}, scan.model.max_range.value_or(0), 0, 0};
  for (const AnonymousDetection& d : scan.detections) search.bearings.push_back(d.bearing.value_or(0));
  std::sort(search.bearings.begin(), search.bearings.end());
  for (const double b : search.bearings) search.rays.emplace_back(std::cos(b), std::sin(b));
  const std::size_t count = search.bearings.size();
  if (count < 3) return std::nullopt;
  search.tolerance = std::tan(4 * scan.detections.front().std_bearing + 0.003);
  search.needed = std::max(6, static_cast<int>(kShare * static_cast<double>(count)));

  std::vector<std::pair<double, std::array<std::size_t, 3>>> triples;
  const auto gap = [&](std::size_t i, std::size_t j) { return wrap(search.bearings[j] - search.bearings[i]); };
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t s = 1; s < 4; ++s)
      for (std::size_t r = 1; r < 4; ++r)
      {
        const std::size_t b = (a + s) % count, c = (b + r) % count;
        const double first = gap(a, b), second = gap(b, c);
        if (std::min(first, second) > kMinGap && std::max(first, second) < kMaxGap && a != c)
          triples.push_back({-std::min(first, second), {a, b, c}});
      }
  std::sort(triples.begin(), triples.end());
  for (std::size_t t = 0; t < std::min(triples.size(), kRounds); ++t)
    if (const auto pose = search.tryTriple(triples[t].second)) return pose;
  return std::nullopt;
}
}  // namespace mrpt_ext::plain
