#include "mrpt_ext/simulation/map_generator.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_map_generator
{
namespace
{
LandmarkTable generate(const MapPlan& plan, std::uint64_t seed = 1)
{
  RandomStream random(seed);
  return generateMap(plan, random);
}
}  // namespace

TEST(MapGenerator, RandomLandmarksKeepBoxAndDistance)
{
  MapPlan plan;
  plan.layout = MapLayout::random;
  plan.count = 20;
  plan.low = {-2, 1, 0.2};
  plan.high = {3, 4, 0.8};
  plan.min_distance = 0.3;
  plan.categories = {"red", "blue"};
  const LandmarkTable map = generate(plan);
  ASSERT_EQ(map.size(), 20U);
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    EXPECT_EQ(map[i].id, static_cast<int>(i) + 1);
    EXPECT_EQ(map[i].category, i % 2 ? "blue" : "red");
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_GE(map[i].position[axis], plan.low[axis]);
      EXPECT_LE(map[i].position[axis], plan.high[axis]);
      EXPECT_DOUBLE_EQ(map[i].position[axis] * 1e6, std::round(map[i].position[axis] * 1e6));
    }
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((map[i].position - map[j].position).head<2>().norm(), plan.min_distance - 1e-5);
  }
}

TEST(MapGenerator, SeedDecidesTheMap)
{
  MapPlan plan;
  plan.layout = MapLayout::random;
  EXPECT_EQ(generate(plan, 3)[0].position, generate(plan, 3)[0].position);
  EXPECT_NE(generate(plan, 3)[0].position, generate(plan, 4)[0].position);
}

TEST(MapGenerator, GridTouchesItsBox)
{
  MapPlan plan;
  plan.layout = MapLayout::grid;
  plan.columns = 3;
  plan.rows = 2;
  plan.high = {4, 2, 0};
  plan.with_ids = false;
  const LandmarkTable map = generate(plan);
  ASSERT_EQ(map.size(), 6U);
  EXPECT_EQ(map[1].position, Vector3d(2, 0, 0));
  EXPECT_EQ(map[5].position, Vector3d(4, 2, 0));
  EXPECT_EQ(map[5].id, kNoId);
}

TEST(MapGenerator, ReportsWhenThereIsNoRoom)
{
  MapPlan plan;
  plan.layout = MapLayout::random;
  plan.count = 100;
  plan.min_distance = 5;
  EXPECT_THROW((void)generate(plan), InputError);
}
}  // namespace mrpt_ext::test_map_generator
