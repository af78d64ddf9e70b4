#include "mrpt_ext/correspondence/points/triangle_index.h"

#include <algorithm>

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kNeighbours = 12;
constexpr int kMaxLengthBins = 160;  // per side: 4 million buckets
constexpr double kEntriesPerBucket = 4;
constexpr double kFlat = 1e-3;  // sine of the smallest angle: the orientation of flatter triangles is not certain

/// The nearest landmarks of one landmark, nearest first.
std::vector<std::uint32_t> nearest(const LandmarkIndex& map, std::size_t landmark, std::size_t count, double& radius)
{
  std::vector<std::pair<double, std::uint32_t>> near;
  const std::size_t wanted = std::min(count, map.size() - 1);
  while (true)
  {
    near.clear();
    map.forEachNear(map.position(landmark), radius,
                    [&](std::size_t other)
                    {
                      const double d2 = (map.position(other) - map.position(landmark)).squaredNorm();
                      if (other != landmark) near.emplace_back(d2, static_cast<std::uint32_t>(other));
                    });
    if (near.size() >= wanted || radius > map.farthestFrom(map.position(landmark))) break;
    radius *= 1.4;
  }
  if (near.size() > 3 * wanted) radius *= 0.8;  // a better first guess for the next landmark
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), wanted));
  std::vector<std::uint32_t> result;
  for (const auto& [d2, other] : near) result.push_back(other);
  return result;
}
}  // namespace

std::optional<Triangle> makeTriangle(const std::array<Vector2d, 3>& points, const std::array<int, 3>& indices)
{
  const auto length = [&](std::size_t a, std::size_t b) { return (points[a] - points[b]).norm(); };
  const std::array opposite{length(1, 2), length(2, 0), length(0, 1)};
  const auto first = static_cast<std::size_t>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
  std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const double turn = cross(points[second] - points[first], points[third] - points[first]);
  if (!(std::abs(turn) > kFlat * square(opposite[first]))) return std::nullopt;
  if (turn < 0) std::swap(second, third);
  return Triangle{{indices[first], indices[second], indices[third]},
                  {opposite[third], opposite[second], opposite[first]}};
}

Triangle rotated(const Triangle& t)
{
  return {{t.corner[1], t.corner[2], t.corner[0]}, {t.side[2], t.side[0], t.side[1]}};
}

TriangleIndex::TriangleIndex(const LandmarkIndex& map)
    : neighbours_(map.size() <= kAllTriangles ? map.size() : kNeighbours)
{
  if (map.size() < 3) return;
  std::vector<Entry> entries;
  collect(map, entries);
  const double count = static_cast<double>(entries.size());
  bins_ = std::clamp(static_cast<int>(3 * std::cbrt(count / kEntriesPerBucket)), 1, kMaxLengthBins);
  // Few triangles are longer than most: they share the last bucket.
  std::vector<std::uint16_t> longest;
  for (const Entry& e : entries) longest.push_back(e.side[2]);
  if (entries.empty()) return;
  const auto most = longest.begin() + static_cast<std::ptrdiff_t>(0.99 * (count - 1));
  std::nth_element(longest.begin(), most, longest.end());
  bin_ = (*most + 1) * unit_ / bins_;
  sortIntoBuckets(entries);
}

void TriangleIndex::collect(const LandmarkIndex& map, std::vector<Entry>& entries)
{
  const Vector2d extent = map.high() - map.low();
  const double area = std::max(extent.prod(), 0.01 * extent.squaredNorm());
  double radius = std::sqrt(static_cast<double>(neighbours_) * area / (kPi * static_cast<double>(map.size())));
  std::vector<std::vector<std::uint32_t>> around;
  double farthest = 0;
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    around.push_back(nearest(map, i, neighbours_, radius));
    farthest = std::max(farthest, (map.position(around[i].back()) - map.position(i)).norm());
  }
  unit_ = std::max(2 * farthest, 1e-9) / 65000;
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < around[i].size(); ++j)
      for (std::size_t k = 0; k < j; ++k)
      {
        const std::array indices{static_cast<int>(i), static_cast<int>(around[i][j]), static_cast<int>(around[i][k])};
        const std::array points{map.position(i), map.position(around[i][j]), map.position(around[i][k])};
        const auto triangle = makeTriangle(points, indices);
        if (!triangle || triangle->corner[0] != indices[0]) continue;
        Entry& entry = entries.emplace_back();
        for (std::size_t s = 0; s < 3; ++s)
        {
          entry.landmark[s] = static_cast<std::uint32_t>(triangle->corner[s]);
          entry.side[s] = static_cast<std::uint16_t>(triangle->side[s] / unit_);
        }
      }
}

void TriangleIndex::sortIntoBuckets(const std::vector<Entry>& entries)
{
  const auto side_of = [&](const Entry& e) {
    return std::array{e.side[0] * unit_, e.side[1] * unit_, e.side[2] * unit_};
  };
  std::vector<std::uint32_t> bucket(entries.size());
  first_.assign(static_cast<std::size_t>(bins_) * static_cast<std::size_t>(bins_) * static_cast<std::size_t>(bins_) + 1,
                0);
  for (std::size_t e = 0; e < entries.size(); ++e)
  {
    bucket[e] = static_cast<std::uint32_t>(bucketOf(binOf(side_of(entries[e]))));
    ++first_[bucket[e] + 1];
  }
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  entries_.resize(entries.size());
  for (std::size_t e = 0; e < entries.size(); ++e) entries_[next[bucket[e]]++] = entries[e];
}

std::size_t TriangleIndex::bytes() const
{
  return entries_.capacity() * sizeof(Entry) + first_.capacity() * sizeof(std::uint32_t);
}

std::size_t TriangleIndex::countNear(const std::array<double, 3>& side, const std::array<double, 3>& tolerance) const
{
  std::size_t count = 0;
  forEachBucket(side, tolerance, [&](std::size_t begin, std::size_t end) { count += end - begin; });
  return count;
}

std::size_t TriangleIndex::bucketOf(const std::array<int, 3>& bin) const
{
  const auto n = static_cast<std::size_t>(bins_);
  return (static_cast<std::size_t>(bin[0]) * n + static_cast<std::size_t>(bin[1])) * n +
         static_cast<std::size_t>(bin[2]);
}

std::array<int, 3> TriangleIndex::binOf(const std::array<double, 3>& side) const
{
  std::array<int, 3> bin{};
  for (std::size_t s = 0; s < 3; ++s)
    bin[s] = static_cast<int>(std::clamp(side[s] / bin_, 0.0, static_cast<double>(bins_ - 1)));
  return bin;
}
}  // namespace mrpt_ext
