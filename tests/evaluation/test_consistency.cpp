#include "mrpt_ext/evaluation/consistency.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_consistency
{
namespace
{
JudgedEstimate offBy(double x, double y, double phi, const Vector3d& std)
{
  JudgedEstimate entry;
  entry.estimate.pose.mean = {x, y, phi};
  entry.estimate.pose.covariance = std.cwiseAbs2().asDiagonal();
  return entry;
}
}  // namespace

TEST(ChiSquare, PublishedQuantiles)
{
  EXPECT_NEAR(chiSquareQuantile(1, 0.95), 3.841, 5e-4);
  EXPECT_NEAR(chiSquareQuantile(3, 0.95), 7.815, 5e-4);
  EXPECT_NEAR(chiSquareQuantile(10, 0.025), 3.247, 5e-4);
}

TEST(Consistency, OneSigmaInEachDirectionIsThree)
{
  const Consistency c = consistency({offBy(0.1, 0.2, 0.3, {0.1, 0.2, 0.3})});
  EXPECT_NEAR(*c.mean, 3, 1e-9);
  EXPECT_NEAR(*c.band_low, chiSquareQuantile(3, 0.025), 1e-9);
  EXPECT_NEAR(*c.band_high, chiSquareQuantile(3, 0.975), 1e-9);
}

TEST(Consistency, HeadingIsWrappedAndOnlyCountsWhereKnown)
{
  EXPECT_NEAR(*consistency({offBy(0, 0, kTwoPi + 0.3, {1, 1, 0.3})}).mean, 1, 1e-9);
  JudgedEstimate without = offBy(0.1, 0.2, 2.0, {0.1, 0.2, 0.3});
  without.truth.heading_known = false;
  const Consistency c = consistency({without});
  EXPECT_NEAR(*c.mean, 2, 1e-9);
  EXPECT_NEAR(*c.band_high, chiSquareQuantile(2, 0.975), 1e-9);
}

TEST(Consistency, TheBandNarrowsAroundTheDegreesOfFreedom)
{
  const Consistency c = consistency(std::vector<JudgedEstimate>(400, offBy(0.1, 0.2, 0.3, {0.1, 0.2, 0.3})));
  EXPECT_GT(*c.band_low, 2.7);
  EXPECT_LT(*c.band_high, 3.3);
}

TEST(Consistency, CoverageCountsTheErrorsWithinTheRegion)
{
  const Vector3d std{0.1, 0.1, 0.1};
  EXPECT_EQ(coverage({offBy(0.27, 0, 0, std), offBy(0.29, 0, 0, std)}, 0.95), 0.5);  // sqrt(7.815) = 2.796
  JudgedEstimate without = offBy(0.25, 0, 2, std);                                   // sqrt(5.991) = 2.448
  without.estimate.heading_known = false;
  EXPECT_EQ(coverage({without}, 0.95), 0.0);
  EXPECT_FALSE(coverage({}, 0.95));
}

TEST(Consistency, ACovarianceOfZeroIsCountedNotScored)
{
  const Consistency c = consistency({offBy(0.1, 0, 0, {0, 0, 0})});
  EXPECT_FALSE(c.mean);
  EXPECT_FALSE(c.band_low);
  EXPECT_EQ(c.count, 0u);
  EXPECT_EQ(c.singular, 1u);
}
}  // namespace mrpt_ext::test_consistency
