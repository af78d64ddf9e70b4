#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_inlier_ratio_monitor
{
TEST(InlierRatioMonitor, IsOneBeforeAnyDetection)
{
  InlierRatioMonitor monitor = InlierRatioMonitor::fast({});
  monitor.observe(0, 1, 0);
  EXPECT_EQ(monitor.average(), 1);
  EXPECT_FALSE(monitor.suspicious());
  EXPECT_FALSE(monitor.lost());
}

TEST(InlierRatioMonitor, TheFirstDetectionsReplaceTheInitialValue)
{
  InlierRatioMonitor monitor = InlierRatioMonitor::fast({});
  monitor.observe(0.4, 0.8, 3);
  EXPECT_NEAR(monitor.average(), 0.5, 1e-12);
}

TEST(InlierRatioMonitor, OfAKnownPoseTheFirstDetectionsDoNotDecideAlone)
{
  InlierRatioMonitor monitor = InlierRatioMonitor::fast({});
  monitor.trust();
  monitor.observe(0, 1, 2);
  EXPECT_NEAR(monitor.average(), 1 - 2.0 / 12, 1e-12);
  EXPECT_FALSE(monitor.suspicious());
}

TEST(InlierRatioMonitor, FallsThroughSuspiciousToLostAndRecovers)
{
  InlierRatioMonitor monitor = InlierRatioMonitor::fast({.reseed_inlier_ratio = 0.5, .lost_inlier_ratio = 0.3});
  for (int k = 0; k < 20; ++k) monitor.observe(0.95, 0.95, 1);
  EXPECT_NEAR(monitor.average(), 1, 1e-12);
  int suspicious_at = 0, lost_at = 0;
  for (int k = 1; k <= 60; ++k)
  {
    monitor.observe(0, 0.95, 1);
    if (monitor.suspicious() && suspicious_at == 0) suspicious_at = k;
    if (monitor.lost() && lost_at == 0) lost_at = k;
  }
  // (11/12)^k falls below 0.5 at k = 8 and below 0.3 at k = 14.
  EXPECT_EQ(suspicious_at, 8);
  EXPECT_EQ(lost_at, 14);
  for (int k = 0; k < 24; ++k) monitor.observe(0.95, 0.95, 1);
  EXPECT_FALSE(monitor.suspicious());
}

TEST(InlierRatioMonitor, ManyDetectionsAtOnceCountAsMany)
{
  InlierRatioMonitor one_by_one = InlierRatioMonitor::fast({}), at_once = one_by_one;
  for (int k = 0; k < 40; ++k) one_by_one.observe(1, 1, 1);
  at_once.observe(1, 1, 40);
  at_once.observe(0, 1, 12);
  EXPECT_NEAR(at_once.average(), 0, 1e-12);
  EXPECT_NEAR(one_by_one.average(), 1, 1e-12);
}

TEST(InlierRatioMonitor, MoreInliersThanExpectedDoNotRaiseTheRatio)
{
  InlierRatioMonitor monitor = InlierRatioMonitor::fast({});
  for (int k = 0; k < 10; ++k) monitor.observe(1, 0.5, 1);
  EXPECT_NEAR(monitor.average(), 1, 1e-12);
  monitor.observe(0, 0, 1);  // nothing was expected: still a number
  EXPECT_TRUE(std::isfinite(monitor.average()));
}

TEST(InlierRatioMonitor, TheImmediateOneFallsFirstAndTheSlowOneLast)
{
  InlierRatioMonitor slow = InlierRatioMonitor::slow({}), fast = InlierRatioMonitor::fast({}),
                     immediate = InlierRatioMonitor::immediate({});
  const auto suspicious_after = [](InlierRatioMonitor& monitor)
  {
    monitor.observe(1, 1, 100);
    int k = 0;
    for (; !monitor.suspicious(); ++k) monitor.observe(0, 1, 1);
    return k;
  };
  EXPECT_EQ(suspicious_after(immediate), 3);  // (3/4)^3 < 0.5
  EXPECT_EQ(suspicious_after(fast), 8);
  EXPECT_EQ(suspicious_after(slow), 42);
}
}  // namespace mrpt_ext::test_inlier_ratio_monitor
