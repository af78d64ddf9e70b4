#include "mrpt_ext/correspondence/landmark_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_landmark_index
{
namespace
{
std::vector<Vector2d> scattered(int count, double width, double height, RandomStream& random)
{
  std::vector<Vector2d> points;
  for (int i = 0; i < count; ++i) points.emplace_back(random.uniform(0, width) + 1e5, random.uniform(0, height) - 3e4);
  return points;
}
}  // namespace

TEST(LandmarkIndex, FindsExactlyThoseWithinTheRadius)
{
  RandomStream random(4);
  for (const double bucket : {0.0, 0.5, 40.0})
    for (const double height : {30.0, 0.0})  // a field, and a line
    {
      const std::vector<Vector2d> points = scattered(300, 50, height, random);
      const LandmarkIndex index(points, bucket);
      for (int trial = 0; trial < 100; ++trial)
      {
        const Vector2d at(1e5 + random.uniform(-20, 70), -3e4 + random.uniform(-20, 50));
        const double radius = random.uniform(0, 30);
        std::vector<std::size_t> found, expected;
        index.forEachNear(at, radius, [&](std::size_t l) { found.push_back(l); });
        for (std::size_t l = 0; l < points.size(); ++l)
          if ((points[l] - at).norm() <= radius) expected.push_back(l);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
        EXPECT_GE(index.farthestFrom(at), (points.front() - at).norm());
      }
    }
}

TEST(LandmarkIndex, TheFarthestLandmarkIsWithinItsOwnDistance)
{
  RandomStream random(5);
  const LandmarkIndex square(std::vector<Vector2d>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Vector2d at(random.uniform(-1, 5), random.uniform(-1, 5));
    int found = 0;
    square.forEachNear(at, square.farthestFrom(at), [&](std::size_t) { ++found; });
    EXPECT_EQ(found, 4);
  }
}

TEST(LandmarkIndex, EmptyAndSingleMaps)
{
  int found = 0;
  LandmarkIndex(std::vector<Vector2d>{}).forEachNear({0, 0}, 10, [&](std::size_t) { ++found; });
  EXPECT_EQ(found, 0);
  LandmarkIndex(std::vector<Vector2d>{{1, 2}}).forEachNear({0, 0}, 10, [&](std::size_t) { ++found; });
  EXPECT_EQ(found, 1);
}

TEST(LandmarkIndex, NumbersCategories)
{
  const LandmarkIndex index(LandmarkTable({{.category = "red"}, {.category = ""}, {.category = "blue"}}));
  EXPECT_EQ(index.categoryOf(""), kAnyCategory);
  EXPECT_EQ(index.categoryOf("unicorn"), kUnknownCategory);
  EXPECT_EQ(index.categoryOf("red"), index.category(0));
  EXPECT_TRUE(index.mayShow(kAnyCategory, 2));
  EXPECT_TRUE(index.mayShow(index.categoryOf("blue"), 2));
  EXPECT_FALSE(index.mayShow(index.categoryOf("blue"), 0));
  EXPECT_FALSE(index.mayShow(kUnknownCategory, 1));
}

TEST(LandmarkIndex, ACategoryCountsByTheCategoriesThatTheMapHas)
{
  const LandmarkTable all_have_one(
      {{.position = {0, 0, 0}, .category = "red"}, {.position = {3, 4, 0}, .category = "blue"}});
  const LandmarkTable some_have_none({{.position = {0, 0, 0}, .category = "red"},
                                      {.position = {3, 4, 0}, .category = "blue"},
                                      {.position = {1, 1, 0}}});
  const SensorModel model;
  const auto volume = [&](const LandmarkTable& map, int category)
  { return LandmarkIndex(map).measurementVolume({.bearing = 0.0, .range = 1.0, .category = category}, model); };
  const double uncategorized = kTwoPi * 1.5 * 5;
  EXPECT_NEAR(volume(all_have_one, kAnyCategory), uncategorized, 1e-12);
  EXPECT_NEAR(volume(all_have_one, 1), 2 * uncategorized, 1e-12);
  EXPECT_NEAR(volume(some_have_none, 1), 3 * uncategorized, 1e-12);
}
}  // namespace mrpt_ext::test_landmark_index
