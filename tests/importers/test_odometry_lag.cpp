#include "mrpt_ext/importers/odometry_lag.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_odometry_lag
{
TEST(OdometryLag, IsTheAgeOfTheOdometry)
{
  const auto lag = odometryLag({1, 2, 3}, {0.5, 1.25, 2, 2.5, 7});
  ASSERT_TRUE(lag);
  EXPECT_EQ(lag->median, 0.5);
  EXPECT_EQ(lag->largest, 4);
  EXPECT_EQ(lag->before, 1u);
  EXPECT_EQ(lag->after, 1u);
  EXPECT_EQ(describe(*lag),
            "at a reading the newest odometry is 0.500 s old (median), 4.000 s at most; 1 reading before the first "
            "odometry; 1 reading after the last odometry");
}

TEST(OdometryLag, IsNothingWithoutOdometry)
{
  EXPECT_FALSE(odometryLag({}, {1, 2}));
  EXPECT_FALSE(odometryLag({5}, {1, 2}));
  EXPECT_FALSE(odometryLag({5}, {}));
}
}  // namespace mrpt_ext::test_odometry_lag
