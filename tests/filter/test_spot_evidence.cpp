#include "mrpt_ext/filter/integrity/spot_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_spot_evidence
{
namespace
{
OdometryMotion ahead(double distance)
{
  return {.increment = {distance, 0, 0}, .path_length = distance, .turned = 0, .duration = 1};
}
}  // namespace

TEST(SpotEvidence, TheFirstReadingOfASensorAtASpotCountsWhole)
{
  SpotEvidence spot({}, 0.3);
  EXPECT_TRUE(spot.isFirstOf("laser"));
  EXPECT_TRUE(spot.isFirstOf("camera"));
  EXPECT_EQ(spot.counted(40, true), 40);
  EXPECT_EQ(spot.counted(-40, true), -40);
}

TEST(SpotEvidence, ASpotEndsAfterTheDistance)
{
  SpotEvidence spot({}, 0.3);
  EXPECT_TRUE(spot.isFirstOf("laser"));
  EXPECT_FALSE(spot.move(ahead(0.2)));
  EXPECT_FALSE(spot.isFirstOf("laser"));
  EXPECT_TRUE(spot.move(ahead(0.2)));
  EXPECT_TRUE(spot.isFirstOf("laser"));
}

TEST(SpotEvidence, WithoutOdometryTheRandomWalkEndsASpot)
{
  SpotEvidence spot({.type = MotionType::random_walk, .std_xy_per_s = 0.5}, 0.3);
  EXPECT_TRUE(spot.move({.duration = 1}));
  EXPECT_FALSE(spot.move({.duration = 0.01}));
}

TEST(SpotEvidence, AnHourOfRepeatedReadingsNeitherProvesNorRefutes)
{
  for (const double ratio : {-3.0, 3.0})
  {
    SpotEvidence spot({}, 0.3);
    double sum = spot.counted(20, true);
    for (int k = 0; k < 30'000; ++k) sum += spot.counted(ratio, false);
    EXPECT_NEAR(sum, 20 + (ratio < 0 ? SpotEvidence::kLeast : SpotEvidence::kMost), 1e-9);
  }
}

TEST(SpotEvidence, LaterReadingsTakeBackAtMostWhatTheFirstGave)
{
  SpotEvidence spot({}, 0.3);
  double sum = spot.counted(1, true);
  for (int k = 0; k < 10; ++k) sum += spot.counted(-3, false);
  EXPECT_DOUBLE_EQ(sum, 0);
}

TEST(SpotEvidence, TheShareOfNewDetectionsFallsWhileTheRobotStands)
{
  SpotEvidence spot({}, 0.3);
  EXPECT_EQ(spot.shareOfNew("laser"), 1);
  spot.count("laser", 10, 10);
  EXPECT_EQ(spot.shareOfNew("laser"), 1);
  for (int k = 0; k < 9; ++k) spot.count("laser", 10, 0);
  EXPECT_NEAR(spot.shareOfNew("laser"), 11.0 / 101, 1e-12);
  EXPECT_EQ(spot.shareOfNew("camera"), 1);
  EXPECT_TRUE(spot.move(ahead(0.4)));
  EXPECT_EQ(spot.shareOfNew("laser"), 1);
}

TEST(SpotEvidence, WhatIsNewCountsLessWhereNothingNewIsExpected)
{
  for (const double ratio : {0.05, 0.5, 3.0, 1000.0})
  {
    EXPECT_NEAR(againstRepetition(std::log(ratio), 1, 0.05), std::log(ratio), 1e-9);
    EXPECT_LT(std::abs(againstRepetition(std::log(ratio), 0.1, 0.05)), std::abs(std::log(ratio)));
    EXPECT_NEAR(againstRepetition(std::log(ratio), 1e-9, 0.05), 0, 1e-4);
  }
  EXPECT_TRUE(std::isfinite(againstRepetition(1e4, 0.5, 0.05)));
  EXPECT_TRUE(std::isfinite(againstRepetition(-1e4, 0.5, 0.05)));
}
}  // namespace mrpt_ext::test_spot_evidence
