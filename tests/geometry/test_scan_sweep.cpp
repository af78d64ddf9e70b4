#include "mrpt_ext/geometry/scan_sweep.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_scan_sweep
{
TEST(ScanSweep, TheStampIsTheTimeOfTheLastBeam)
{
  const ScanSweep left{.duration = 0.2}, right{.duration = 0.2, .direction = SweepDirection::clockwise};
  EXPECT_NEAR(left.ageOf(-kPi + 1e-9, kTwoPi), 0.2, 1e-9);
  EXPECT_NEAR(left.ageOf(0, kTwoPi), 0.1, 1e-12);
  EXPECT_NEAR(left.ageOf(kPi - 1e-9, kTwoPi), 0, 1e-9);
  EXPECT_NEAR(right.ageOf(kPi - 1e-9, kTwoPi), 0.2, 1e-9);
  EXPECT_NEAR(right.ageOf(kPi / 2, kTwoPi), 0.15, 1e-12);
  EXPECT_EQ(ScanSweep{}.ageOf(1, kTwoPi), 0);
}

TEST(ScanSweep, ASectorIsSweptFromEdgeToEdge)
{
  const ScanSweep left{.duration = 0.2};
  EXPECT_NEAR(left.ageOf(-kPi / 2, kPi), 0.2, 1e-12);
  EXPECT_NEAR(left.ageOf(kPi / 4, kPi), 0.05, 1e-12);
  EXPECT_EQ(left.ageOf(kPi / 2 + 0.1, kPi), 0) << "beyond the edge: the last beam";
}

TEST(ScanSweep, TheTurnMayBeginAnywhere)
{
  const ScanSweep left{.duration = 0.2, .start = 0};
  EXPECT_NEAR(left.ageOf(0, kTwoPi), 0.2, 1e-12);
  EXPECT_NEAR(left.ageOf(kPi / 2, kTwoPi), 0.15, 1e-12);
  EXPECT_NEAR(left.ageOf(-1e-9, kTwoPi), 0, 1e-9);
  const ScanSweep right{.duration = 0.2, .direction = SweepDirection::clockwise, .start = 0};
  EXPECT_NEAR(right.ageOf(kPi / 2, kTwoPi), 0.05, 1e-12);
}
}  // namespace mrpt_ext::test_scan_sweep
