#include "mrpt_ext/filter/particles/kld_size.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_kld_size
{
namespace
{
ParticleSet at(const std::vector<Pose2>& poses)
{
  ParticleSet particles;
  for (const Pose2& pose : poses) particles.add(pose, 0);
  return particles;
}

constexpr KldOptions kOptions{.bin_xy = 0.5, .bin_phi = degToRad(10)};
}  // namespace

/// Worked out apart from the code, with the normal quantiles z(0.99) = 2.3263478740 and z(0.95) = 1.6448536270.
TEST(KldSampleSize, KnownValues)
{
  EXPECT_NEAR(kldSampleSize(2, 0.02, 0.01), 164.64432742, 1e-5);
  EXPECT_NEAR(kldSampleSize(11, 0.05, 0.05), 182.91782066, 1e-5);
  EXPECT_NEAR(kldSampleSize(101, 0.02, 0.01), 3395.50207952, 1e-5);
}

/// The formula approximates the chi-square quantile over 2 epsilon; quantiles from a printed table.
TEST(KldSampleSize, IsCloseToTheChiSquareQuantile)
{
  EXPECT_NEAR(kldSampleSize(2, 0.02, 0.01), 6.635 / 0.04, 0.01 * 6.635 / 0.04);
  EXPECT_NEAR(kldSampleSize(11, 0.05, 0.05), 18.307 / 0.1, 0.002 * 18.307 / 0.1);
  EXPECT_NEAR(kldSampleSize(101, 0.02, 0.01), 135.807 / 0.04, 0.0005 * 135.807 / 0.04);
}

TEST(KldSampleSize, OneBinNeedsOneParticle)
{
  EXPECT_EQ(kldSampleSize(1, 0.02, 0.01), 1);
  EXPECT_EQ(kldSampleSize(0, 0.02, 0.01), 1);
}

TEST(KldSampleSize, GrowsWithTheBinsAndWithTheDemand)
{
  for (std::size_t bins = 2; bins < 1000; bins *= 2)
    EXPECT_LT(kldSampleSize(bins, 0.02, 0.01), kldSampleSize(2 * bins, 0.02, 0.01));
  EXPECT_LT(kldSampleSize(50, 0.05, 0.01), kldSampleSize(50, 0.02, 0.01));
  EXPECT_LT(kldSampleSize(50, 0.02, 0.1), kldSampleSize(50, 0.02, 0.01));
}

TEST(OccupiedBins, CountsEveryBinOnce)
{
  EXPECT_EQ(occupiedBins(at({{0.1, 0.1, 0.01}, {0.2, 0.3, 0.02}, {0.6, 0.1, 0.01}, {0.1, -0.1, 0.01}}), kOptions), 3u);
  EXPECT_EQ(occupiedBins({}, kOptions), 0u);
}

TEST(OccupiedBins, HeadingBinsCloseAtPi)
{
  const double beyond = kPi + 0.01;
  EXPECT_EQ(occupiedBins(at({{0.1, 0.1, beyond}, {0.1, 0.1, -kPi + 0.02}}), kOptions), 1u);
  EXPECT_EQ(occupiedBins(at({{0.1, 0.1, beyond}, {0.1, 0.1, beyond - kTwoPi}, {0.1, 0.1, beyond + kTwoPi}}), kOptions),
            1u);
  ParticleSet around;
  for (int deg = 0; deg < 7200; ++deg) around.add({0.1, 0.1, degToRad(deg + 0.5)}, 0);
  EXPECT_EQ(occupiedBins(around, kOptions), 36u);
}
}  // namespace mrpt_ext::test_kld_size
