#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"

namespace mrpt_ext
{
/// Three points in counter-clockwise order, beginning with the one that faces the longest side.
struct Triangle
{
  std::array<int, 3> corner{0, 0, 0};
  std::array<double, 3> side{0, 0, 0};  ///< [m] corner 0 to 1, 0 to 2, 1 to 2 (the longest)
};

/// A triangle in that form; nothing for points on one line or at one point.
[[nodiscard]] std::optional<Triangle> makeTriangle(const std::array<Vector2d, 3>& points,
                                                   const std::array<int, 3>& indices);

/// The same triangle, begun at its next corner.
[[nodiscard]] Triangle rotated(const Triangle& triangle);

/// Triangles of near landmarks, found by the lengths of their sides, which no motion changes (as star trackers do).
/// Every landmark forms one with each two of its `neighbours()` nearest landmarks, listed once, under the corner
/// that faces the longest side. A triangle is in the index if its other corners are among the nearest neighbours of
/// that corner. Of maps of up to kAllTriangles landmarks all triangles are listed.
/// Built in O(N log N); about 20 bytes per triangle, 40 triangles per landmark.
class TriangleIndex
{
 public:
  static constexpr std::size_t kAllTriangles = 30;

  explicit TriangleIndex(const LandmarkIndex& map);

  [[nodiscard]] std::size_t neighbours() const { return neighbours_; }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] std::size_t bytes() const;

  /// Largest number of entries that a query visits.
  [[nodiscard]] std::size_t countNear(const std::array<double, 3>& side, const std::array<double, 3>& tolerance) const;

  /// Calls visit(landmarks of corner 0, 1, 2) for every triangle whose sides differ by no more than the tolerances.
  template <typename Visit>
  void forEachNear(const std::array<double, 3>& side, const std::array<double, 3>& tolerance, Visit&& visit) const
  {
    forEachBucket(side, tolerance,
                  [&](std::size_t begin, std::size_t end)
                  {
                    for (std::size_t e = begin; e < end; ++e)
                      if (entries_[e].fits(side, tolerance, unit_)) visit(entries_[e].landmark);
                  });
  }

 private:
  struct Entry
  {
    std::array<std::uint32_t, 3> landmark;
    std::array<std::uint16_t, 3> side;  // [unit_]

    [[nodiscard]] bool fits(const std::array<double, 3>& wanted, const std::array<double, 3>& tolerance,
                            double unit) const
    {
      for (std::size_t s = 0; s < 3; ++s)
        if (std::abs(static_cast<double>(side[s]) * unit - wanted[s]) > tolerance[s] + unit) return false;
      return true;
    }
  };

  void collect(const LandmarkIndex& map, std::vector<Entry>& entries);
  void sortIntoBuckets(const std::vector<Entry>& entries);
  [[nodiscard]] std::size_t bucketOf(const std::array<int, 3>& bin) const;
  [[nodiscard]] std::array<int, 3> binOf(const std::array<double, 3>& side) const;

  template <typename Visit>
  void forEachBucket(const std::array<double, 3>& side, const std::array<double, 3>& tolerance, Visit&& visit) const
  {
    if (entries_.empty()) return;
    const std::array<int, 3> low = binOf({side[0] - tolerance[0], side[1] - tolerance[1], side[2] - tolerance[2]});
    const std::array<int, 3> high = binOf({side[0] + tolerance[0], side[1] + tolerance[1], side[2] + tolerance[2]});
    for (int a = low[0]; a <= high[0]; ++a)
      for (int b = low[1]; b <= high[1]; ++b)
        // buckets that differ in the last side only are contiguous
        visit(first_[bucketOf({a, b, low[2]})], first_[bucketOf({a, b, high[2]}) + 1]);
  }

  std::size_t neighbours_ = 0;
  double bin_ = 1;   // [m] width of a bucket in each side
  double unit_ = 1;  // [m] resolution of the stored sides
  int bins_ = 1;     // per side
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> first_;  // per bucket, one more at the end
};
}  // namespace mrpt_ext
