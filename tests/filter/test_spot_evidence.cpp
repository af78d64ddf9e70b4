#include "mrpt_ext/filter/integrity/spot_evidence.h"

#include <gtest/gtest.h>

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
}  // namespace mrpt_ext::test_spot_evidence
