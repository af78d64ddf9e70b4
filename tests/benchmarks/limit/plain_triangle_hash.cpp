#include "limit/plain_triangle_hash.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace mrpt_ext
{
namespace
{
constexpr double kCell = 4;
constexpr std::size_t kNeighbours = 10, kNearPoints = 4;

int rounded(double length, double bin) { return static_cast<int>(length / bin); }
double turn(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Pose2 fit(const std::array<Vector2d, 3>& seen, const std::array<Vector2d, 3>& landmarks)
{
  const Vector2d ms = (seen[0] + seen[1] + seen[2]) / 3, ml = (landmarks[0] + landmarks[1] + landmarks[2]) / 3;
  double c = 0, s = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    c += (seen[k] - ms).dot(landmarks[k] - ml);
    s += turn(seen[k] - ms, landmarks[k] - ml);
  }
  const double phi = std::atan2(s, c);
  const Vector2d at = ml - rotation(phi) * ms;
  return {at.x(), at.y(), phi};
}
}  // namespace

std::uint64_t PlainTriangleHash::key(int a, int b, int c)
{
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 40) ^
         (static_cast<std::uint64_t>(static_cast<std::uint32_t>(b)) << 20) ^ static_cast<std::uint32_t>(c);
}

PlainTriangleHash::PlainTriangleHash(const std::vector<Vector2d>& landmarks, const Vector2d& low, double bin)
    : landmarks_(landmarks), low_(low), bin_(bin)
{
  for (std::size_t i = 0; i < landmarks_.size(); ++i)
  {
    const Vector2d d = (landmarks_[i] - low_) / kCell;
    cells_[key(0, static_cast<int>(d.x()), static_cast<int>(d.y()))].push_back(static_cast<int>(i));
  }
  for (int i = 0; i < static_cast<int>(landmarks_.size()); ++i)
  {
    const Vector2d& at = landmarks_[static_cast<std::size_t>(i)];
    std::vector<int> around = near(at, 2 * kCell);
    std::erase(around, i);
    const auto distance = [&](int l) { return (landmarks_[static_cast<std::size_t>(l)] - at).norm(); };
    std::sort(around.begin(), around.end(), [&](int a, int b) { return distance(a) < distance(b); });
    if (around.size() > kNeighbours) around.resize(kNeighbours);
    for (const int j : around)
      for (const int k : around)
      {
        const Vector2d &pj = landmarks_[static_cast<std::size_t>(j)], &pk = landmarks_[static_cast<std::size_t>(k)];
        if (j == k || turn(pj - at, pk - at) <= 0) continue;
        triangles_[key(rounded(distance(j), bin_), rounded(distance(k), bin_), rounded((pj - pk).norm(), bin_))]
            .push_back({i, j, k});
      }
  }
}

std::vector<int> PlainTriangleHash::near(const Vector2d& at, double radius) const
{
  std::vector<int> found;
  const Vector2d low = (at - low_ - Vector2d(radius, radius)) / kCell,
                 high = (at - low_ + Vector2d(radius, radius)) / kCell;
  for (int x = std::max(0, static_cast<int>(low.x())); x <= static_cast<int>(high.x()); ++x)
    for (int y = std::max(0, static_cast<int>(low.y())); y <= static_cast<int>(high.y()); ++y)
      if (const auto cell = cells_.find(key(0, x, y)); cell != cells_.end())
        for (const int l : cell->second)
          if ((landmarks_[static_cast<std::size_t>(l)] - at).norm() <= radius) found.push_back(l);
  return found;
}

int PlainTriangleHash::explained(const std::vector<Vector2d>& points, const Pose2& pose, double tolerance) const
{
  int count = 0;
  for (const Vector2d& point : points) count += !near(transform(pose, point), tolerance).empty();
  return count;
}

std::optional<Pose2> PlainTriangleHash::find(const std::vector<Vector2d>& points, double tolerance) const
{
  const int wanted = std::max(5, static_cast<int>(0.75 * static_cast<double>(points.size())));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<Vector2d> others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    std::sort(others.begin(), others.end(),
              [&](const Vector2d& a, const Vector2d& b) { return (a - points[i]).norm() < (b - points[i]).norm(); });
    if (others.size() > kNearPoints) others.resize(kNearPoints);
    for (const Vector2d& b : others)
      for (const Vector2d& c : others)
      {
        if (turn(b - points[i], c - points[i]) <= 0) continue;
        const std::array side{(b - points[i]).norm(), (c - points[i]).norm(), (b - c).norm()};
        for (int x = rounded(side[0] - tolerance, bin_); x <= rounded(side[0] + tolerance, bin_); ++x)
          for (int y = rounded(side[1] - tolerance, bin_); y <= rounded(side[1] + tolerance, bin_); ++y)
            for (int z = rounded(side[2] - tolerance, bin_); z <= rounded(side[2] + tolerance, bin_); ++z)
            {
              const auto bucket = triangles_.find(key(x, y, z));
              if (bucket == triangles_.end()) continue;
              for (const Corners& t : bucket->second)
              {
                const auto place = [&](int l) { return landmarks_[static_cast<std::size_t>(l)]; };
                const Pose2 pose = fit({points[i], b, c}, {place(t.a), place(t.b), place(t.c)});
                if (explained(points, pose, 2 * tolerance) >= wanted) return pose;
              }
            }
      }
  }
  return std::nullopt;
}
}  // namespace mrpt_ext
