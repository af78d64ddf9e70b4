#include "mrpt_ext/correspondence/points/triangle_index.h"

#include <gtest/gtest.h>

#include <set>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_triangle_index
{
namespace
{
std::vector<Vector2d> strewn(int count, double side, std::uint64_t seed)
{
  RandomStream random(seed);
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(random.uniform(0, side), random.uniform(0, side));
  return points;
}

using Corners = std::array<std::uint32_t, 3>;

std::set<Corners> lookUp(const TriangleIndex& index, const Triangle& triangle, double tolerance)
{
  std::set<Corners> found;
  index.forEachNear(triangle.side, {tolerance, tolerance, tolerance}, [&](const Corners& c) { found.insert(c); });
  return found;
}
}  // namespace

TEST(Triangle, BeginsWhereTheLongestSideIsFacedAndTurnsLeft)
{
  const auto t = makeTriangle({Vector2d(0, 0), Vector2d(4, 0), Vector2d(1, 1)}, {7, 8, 9});
  ASSERT_TRUE(t);
  EXPECT_EQ(t->corner, (std::array{9, 7, 8}));
  EXPECT_NEAR(t->side[2], 4, 1e-12);
  EXPECT_NEAR(t->side[0], std::sqrt(2.0), 1e-12);
  const Triangle again = rotated(rotated(rotated(*t)));
  EXPECT_EQ(again.corner, t->corner);
  EXPECT_EQ(again.side, t->side);
  EXPECT_NEAR(rotated(*t).side[0], 4, 1e-12);
}

TEST(Triangle, PointsOnALineMakeNone)
{
  EXPECT_FALSE(makeTriangle({Vector2d(0, 0), Vector2d(1, 0), Vector2d(2, 0)}, {0, 1, 2}));
  EXPECT_FALSE(makeTriangle({Vector2d(0, 0), Vector2d(0, 0), Vector2d(2, 0)}, {0, 1, 2}));
}

TEST(TriangleIndex, HoldsEveryTriangleOfASmallMapOnce)
{
  const std::vector<Vector2d> points = strewn(12, 10, 3);
  const TriangleIndex index{LandmarkIndex(points)};
  EXPECT_EQ(index.size(), 220u);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < j; ++k)
      {
        const auto t = makeTriangle({points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(j)],
                                     points[static_cast<std::size_t>(k)]},
                                    {i, j, k});
        ASSERT_TRUE(t);
        const Corners wanted{static_cast<std::uint32_t>(t->corner[0]), static_cast<std::uint32_t>(t->corner[1]),
                             static_cast<std::uint32_t>(t->corner[2])};
        EXPECT_TRUE(lookUp(index, *t, 1e-3).contains(wanted));
      }
}

TEST(TriangleIndex, FindsExactlyWhatFits)
{
  std::vector<Vector2d> points = strewn(25, 15, 9);
  // One that fits, and its mirror image, whatever the others are.
  points.insert(points.end(), {{5, 5}, {9, 5}, {5.625, 9.961}, {5.625, 0.039}});
  const TriangleIndex index{LandmarkIndex(points)};
  const Triangle asked{{0, 0, 0}, {4, 5, 6}};
  constexpr double kTolerance = 0.3, kRounding = 1e-3;
  const std::set<Corners> found = lookUp(index, asked, kTolerance);
  EXPECT_FALSE(found.empty());
  const auto within = [&](const Corners& c, double tolerance)
  {
    const auto side = [&](std::size_t a, std::size_t b) { return (points[c[a]] - points[c[b]]).norm(); };
    return std::abs(side(0, 1) - 4) <= tolerance && std::abs(side(0, 2) - 5) <= tolerance &&
           std::abs(side(1, 2) - 6) <= tolerance;
  };
  for (const Corners& c : found) EXPECT_TRUE(within(c, kTolerance + 2 * kRounding));
  EXPECT_GE(index.countNear(asked.side, {kTolerance, kTolerance, kTolerance}), found.size());
}

TEST(TriangleIndex, AMirrorImageIsAnotherTriangle)
{
  const std::vector<Vector2d> points{{0, 0}, {3, 0}, {0.5, 2}};
  const TriangleIndex index{LandmarkIndex(points)};
  const std::vector<Vector2d> mirrored{{0, 0}, {3, 0}, {0.5, -2}};
  const auto same = makeTriangle({points[0], points[1], points[2]}, {0, 1, 2});
  const auto other = makeTriangle({mirrored[0], mirrored[1], mirrored[2]}, {0, 1, 2});
  ASSERT_TRUE(same && other);
  EXPECT_EQ(lookUp(index, *same, 0.01).size(), 1u);
  EXPECT_TRUE(lookUp(index, *other, 0.01).empty());
}

TEST(TriangleIndex, LargeMapsHoldTheTrianglesOfNearestNeighbours)
{
  const std::vector<Vector2d> points = strewn(2000, 140, 5);
  const LandmarkIndex map(points);
  const TriangleIndex index(map);
  int asked = 0;
  for (std::size_t i = 0; i < 200; ++i)
  {
    std::vector<std::pair<double, std::size_t>> near;
    map.forEachNear(points[i], 8,
                    [&](std::size_t l)
                    {
                      if (l != i) near.emplace_back((points[l] - points[i]).norm(), l);
                    });
    std::sort(near.begin(), near.end());
    if (near.size() < 6) continue;
    const auto t =
        makeTriangle({points[i], points[near[2].second], points[near[5].second]},
                     {static_cast<int>(i), static_cast<int>(near[2].second), static_cast<int>(near[5].second)});
    if (!t || t->corner[0] != static_cast<int>(i)) continue;
    ++asked;
    EXPECT_TRUE(lookUp(index, *t, 0.01)
                    .contains({static_cast<std::uint32_t>(t->corner[0]), static_cast<std::uint32_t>(t->corner[1]),
                               static_cast<std::uint32_t>(t->corner[2])}));
  }
  EXPECT_GT(asked, 20);
}

TEST(TriangleIndex, MapsWithoutTriangles)
{
  for (const std::vector<Vector2d>& points :
       {std::vector<Vector2d>{}, {{0, 0}}, {{0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {2, 2}}, {{1, 1}, {1, 1}, {1, 1}}})
  {
    const TriangleIndex index{LandmarkIndex(points)};
    EXPECT_EQ(index.size(), 0u);
    EXPECT_TRUE(lookUp(index, {{0, 0, 0}, {1, 1, 1}}, 0.5).empty());
  }
}
}  // namespace mrpt_ext::test_triangle_index
