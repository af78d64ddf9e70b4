#include "mrpt_ext/correspondence/bearings/bearing_search_tables.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_bearing_search_tables
{
namespace
{
const LandmarkIndex kMap(LandmarkTable({{.position = {0, 0, 0}, .category = "red"},
                                        {.position = {9, 0, 0}, .category = "blue"},
                                        {.position = {0, 9, 0}, .category = "blue"}}));
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
const Box2 kArea{{0, 0}, {9, 9}};
}  // namespace

TEST(BearingSearchTables, EachTableIsBuiltOnce)
{
  const BearingSearchTables tables(kMap);
  EXPECT_EQ(tables.visibleSets(8), tables.visibleSets(8));
  EXPECT_NE(tables.visibleSets(8), tables.visibleSets(kNoLimit));
  EXPECT_EQ(tables.neighboursOf(kMap.categoryOf("blue")), tables.neighboursOf(kMap.categoryOf("blue")));
  EXPECT_NE(tables.neighboursOf(kMap.categoryOf("blue")), tables.neighboursOf(kAnyCategory));
}

TEST(BearingSearchTables, KeepsTheTwoLatestGrids)
{
  const BearingSearchTables tables(kMap);
  EXPECT_EQ(tables.builtVisibilityGrid(kArea, kNoLimit), nullptr);
  const auto layout = [](double side) {
    return *VisibilityGrid::chooseLayout(kMap, {{0, 0}, {side, side}}, kNoLimit, 4);
  };
  const auto first = tables.visibilityGrid(layout(9));
  EXPECT_EQ(tables.visibilityGrid(layout(9)), first);
  EXPECT_EQ(tables.builtVisibilityGrid(kArea, kNoLimit), first);
  EXPECT_NE(tables.visibilityGrid(layout(8)), nullptr);
  EXPECT_EQ(tables.builtVisibilityGrid(kArea, kNoLimit), first);
  EXPECT_NE(tables.visibilityGrid(layout(7)), nullptr);
  EXPECT_EQ(tables.builtVisibilityGrid(kArea, kNoLimit), nullptr);
}
}  // namespace mrpt_ext::test_bearing_search_tables
