#include "mrpt_ext/filter/sampling_error.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_sampling_error
{
namespace
{
ModeSet oneMode(double weight = 1) { return {{{{{}, Matrix3d::Identity()}, weight}}, {}}; }

double corrected(SamplingError& error, double effective, double remainder, double weight = 1)
{
  ModeSet modes = oneMode(weight);
  error.correct(modes, effective, remainder);
  return modes.modes.front().pose.covariance(0, 0);
}
}  // namespace

TEST(SamplingError, EnlargesTheCovarianceOfASmallSample)
{
  SamplingError error;
  EXPECT_NEAR(corrected(error, 101, 0), 102.0 / 100, 1e-12);
  EXPECT_NEAR(corrected(error, 202, 0, 0.5), 102.0 / 100, 1e-12) << "those of the mode";
  EXPECT_NEAR(corrected(error, 1, 0), 5.0 / 3, 1e-12) << "four particles at least";
}

TEST(SamplingError, CannotCorrectTheCovarianceOfThreeParticles)
{
  EXPECT_FALSE(SamplingError::corrects(3.9));
  EXPECT_TRUE(SamplingError::corrects(4));
}

TEST(SamplingError, AccumulatesTheRemainingSamplingVariance)
{
  SamplingError error;
  (void)corrected(error, 100, 0);
  EXPECT_NEAR(corrected(error, 100, 0.5), 101.0 / 99 * (1 + 0.5 / 100), 1e-12);
  EXPECT_NEAR(corrected(error, 100, 0.5), 101.0 / 99 * (1 + 0.5 * 1.5 / 100), 1e-12);
  EXPECT_NEAR(corrected(error, 100, 0), 101.0 / 99, 1e-12) << "a new mode";
}

TEST(SamplingError, ClonesOfOneParticleCountAsOneUntilMeasurementsReplaceWhatItKnew)
{
  SamplingError error;
  (void)corrected(error, 2000, 0);
  EXPECT_NEAR(error.effectiveAncestors(), 2000, 1e-9);
  (void)corrected(error, 1, 0.9);  // a surprise: one is left, and resampled
  EXPECT_NEAR(error.effectiveAncestors(), 1, 0.01);
  (void)corrected(error, 2000, 0.9);
  EXPECT_NEAR(error.effectiveAncestors(), 1 / 0.9, 0.01);
  for (int k = 0; k < 30; ++k) (void)corrected(error, 2000, 0.9);
  EXPECT_GT(error.effectiveAncestors(), 15);
}

TEST(SamplingError, TheRemainderIsThatOfTheKalmanGain)
{
  const Matrix3d I = Matrix3d::Identity();
  EXPECT_NEAR(SamplingError::remainder(I, I, I), 1, 1e-12) << "without a measurement all of it";
  EXPECT_NEAR(SamplingError::remainder(I, 2 * I, 0.5 * I), 0.5 / 4, 1e-12);
  EXPECT_EQ(SamplingError::remainder(I, 0.1 * I, I), 1) << "never more";
  EXPECT_EQ(SamplingError::remainder(I, Matrix3d::Zero(), I), 0);
}
}  // namespace mrpt_ext::test_sampling_error
