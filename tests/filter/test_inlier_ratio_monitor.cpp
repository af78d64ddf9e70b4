#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext
{
TEST(InlierRatioMonitor, TrustsBeforeAnythingIsSeen)
{
  InlierRatioMonitor monitor({});
  monitor.observe(0, 1, 0);
  EXPECT_EQ(monitor.average(), 1);
  EXPECT_FALSE(monitor.suspicious());
  EXPECT_FALSE(monitor.lost());
}

TEST(InlierRatioMonitor, TheFirstDetectionsReplaceTheTrust)
{
  InlierRatioMonitor monitor({});
  monitor.observe(0.4, 0.8, 3);
  EXPECT_NEAR(monitor.average(), 0.5, 1e-12);
}

TEST(InlierRatioMonitor, PassesThroughSuspicionToLostAndBack)
{
  InlierRatioMonitor monitor({.reseed_inlier_ratio = 0.5, .lost_share = 0.3, .memory_detections = 12});
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
  InlierRatioMonitor one_by_one({}), at_once({});
  for (int k = 0; k < 40; ++k) one_by_one.observe(1, 1, 1);
  at_once.observe(1, 1, 40);
  at_once.observe(0, 1, 12);
  EXPECT_NEAR(at_once.average(), 0, 1e-12);
  EXPECT_NEAR(one_by_one.average(), 1, 1e-12);
}

TEST(InlierRatioMonitor, ExplainingMoreThanExpectedIsNoCredit)
{
  InlierRatioMonitor monitor({});
  for (int k = 0; k < 10; ++k) monitor.observe(1, 0.5, 1);
  EXPECT_NEAR(monitor.average(), 1, 1e-12);
  monitor.observe(0, 0, 1);  // nothing was expected: still a number
  EXPECT_TRUE(std::isfinite(monitor.average()));
}
}  // namespace mrpt_ext
