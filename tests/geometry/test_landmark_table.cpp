#include "mrpt_ext/geometry/landmark_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_landmark_table
{
namespace
{
Landmark at(int id, double x, double y) { return {.id = id, .position = {x, y, 0}}; }
}  // namespace

TEST(LandmarkTable, FindsByIdAndKeepsOrder)
{
  const LandmarkTable table({at(7, 1, 2), at(kNoId, 3, 4), at(2, 5, 6)});
  EXPECT_EQ(table.size(), 3U);
  EXPECT_EQ(table.indexOf(7), 0U);
  EXPECT_EQ(table.indexOf(2), 2U);
  EXPECT_FALSE(table.indexOf(3).has_value());
  EXPECT_FALSE(table.indexOf(kNoId).has_value());
}

TEST(LandmarkTable, RejectsAnIdTwice) { EXPECT_THROW(LandmarkTable({at(1, 0, 0), at(1, 1, 1)}), InputError); }

TEST(LandmarkTable, RejectsNonFinite)
{
  EXPECT_THROW(LandmarkTable({at(1, std::numeric_limits<double>::quiet_NaN(), 0)}), InputError);
}

TEST(LandmarkTable, BoundingBoxHoldsAll)
{
  const auto [low, high] = LandmarkTable({at(1, -1, 5), at(2, 3, -2)}).boundingBox();
  EXPECT_EQ(low, Vector2d(-1, -2));
  EXPECT_EQ(high, Vector2d(3, 5));
}
}  // namespace mrpt_ext::test_landmark_table
