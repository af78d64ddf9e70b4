#include "mrpt_ext/report/map_view.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_map_view
{
TEST(MapView, KeepsTheShapeAndPointsUpwards)
{
  const MapView view({0, 0}, {10, 5});
  const Vector2d low = view.draw({0, 0}), high = view.draw({10, 5});
  EXPECT_LT(low.x(), high.x());
  EXPECT_GT(low.y(), high.y());
  EXPECT_NEAR((high.x() - low.x()) / (low.y() - high.y()), 2, 1e-9);
  EXPECT_TRUE(view.contains(low) && view.contains(high));
  EXPECT_FALSE(view.contains(view.draw({20, 0})));
}

TEST(MapView, OfNothingOrOnePointIsFinite)
{
  EXPECT_TRUE(viewOf(RunContext{}, nullptr).draw({0, 0}).allFinite());
  EXPECT_GT(MapView({3, 3}, {3, 3}).scale(), 0);
}
}  // namespace mrpt_ext::test_map_view
