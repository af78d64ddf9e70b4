#include "mrpt_ext/geometry/quantile.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_quantile
{
TEST(Quantile, InterpolatesBetweenNeighbours)
{
  EXPECT_DOUBLE_EQ(*quantile({4, 1, 1}, 0.95),
                   1 + 0.9 * 3);  // position 0.95 * 2 = 1.9 between the second and the third
  EXPECT_DOUBLE_EQ(*quantile({4, 1, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(*quantile({4, 1, 2}, 1), 4);
}

TEST(Quantile, OfNothingDoesNotExist)
{
  EXPECT_FALSE(quantile({}, 0.5));
  EXPECT_FALSE(median({}));
}

TEST(Median, OfAnEvenSampleIsHalfWay) { EXPECT_DOUBLE_EQ(*median({1, 10, 2, 4}), 3); }

TEST(UpperMedian, IsOneOfTheValues)
{
  EXPECT_DOUBLE_EQ(upperMedian({1, 10, 2, 4}), 4);
  EXPECT_DOUBLE_EQ(upperMedian({3, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(upperMedian({7}), 7);
}
}  // namespace mrpt_ext::test_quantile
