#include "mrpt_ext/diagnosis/outlier_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mrpt_ext
{
namespace
{
constexpr double kFar = 2 * kOutlierMisfit;

struct Sample
{
  CalibrationData data;
  std::vector<double> misfits;

  void addReading(std::size_t pose, bool is_range, double misfit)
  {
    data.problem.readings.push_back({.pose = pose, .is_range = is_range});
    misfits.push_back(misfit);
  }
};

/// A reading of one bearing per pose, with outliers that matched a landmark and others that none is near.
Sample bearings(std::size_t poses, double matched, double unmatched)
{
  Sample sample;
  sample.data.problem.poses.resize(poses);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t k = 0; k < poses; ++k)
    if (const double u = uniform(random); u < unmatched)
      sample.data.unmatched.push_back({k, 0, false});
    else
      sample.addReading(k, false, u < unmatched + matched ? kFar : 1);
  return sample;
}

TEST(OutlierShare, CountsWhatIsFarFromItsLandmarkAndWhatNoLandmarkIsNear)
{
  const Sample sample = bearings(4000, 0.05, 0.12);
  const OutlierShare found = outlierShare(sample.data, sample.misfits, 0);
  EXPECT_EQ(found.readings, 4000U);
  EXPECT_NEAR(found.share, 0.17, 4 * found.std);
  EXPECT_NEAR(found.std, std::sqrt(0.17 * 0.83 / 4000), 5e-4);
}

TEST(OutlierShare, AShareThatIsSmallIsNotLost)
{
  const Sample sample = bearings(4000, 0.01, 0);
  const OutlierShare found = outlierShare(sample.data, sample.misfits, 0);
  EXPECT_NEAR(found.share, 0.01, 4 * found.std);
  EXPECT_GT(found.share, 0);
}

TEST(OutlierShare, ATimeAtAWrongPoseIsNoClutter)
{
  Sample sample = bearings(4000, 0.05, 0);
  for (std::size_t k = 1000; k < 1400; ++k) sample.misfits[k] = kFar;
  const OutlierShare found = outlierShare(sample.data, sample.misfits, 0);
  EXPECT_NEAR(found.share, 0.05, 4 * found.std);
  EXPECT_NEAR(static_cast<double>(found.readings), 3600, 1);
}

TEST(OutlierShare, StopsBeforeTheGivenPose)
{
  Sample sample = bearings(2000, 0, 0);
  for (std::size_t k = 1000; k < 2000; ++k) sample.data.unmatched.push_back({k, 0, false});
  EXPECT_EQ(outlierShare(sample.data, sample.misfits, 0, 1000).share, 0);
}

TEST(OutlierShare, TheWorseOfBearingsAndRangesCounts)
{
  Sample sample = bearings(2000, 0.02, 0);
  for (std::size_t k = 0; k < 2000; ++k) sample.addReading(k, true, k % 5 == 0 ? kFar : 0);
  EXPECT_NEAR(outlierShare(sample.data, sample.misfits, 0).share, 0.2, 1e-9);
}

TEST(OutlierShare, TellsHowManyReadingsHaveALandmark)
{
  const Sample sample = bearings(1000, 0.05, 0.3);
  EXPECT_EQ(outlierShare(sample.data, sample.misfits, 0).matched, sample.misfits.size());
}

TEST(OutlierShare, NothingOfASensorWithoutALandmark)
{
  const Sample sample = bearings(1000, 0, 1);
  ASSERT_EQ(sample.data.unmatched.size(), 1000U);
  EXPECT_EQ(outlierShare(sample.data, sample.misfits, 0).share, 0);
}

TEST(OutlierShare, NothingOfASensorWithoutReadings)
{
  const Sample sample = bearings(100, 0, 0);
  EXPECT_EQ(outlierShare(sample.data, sample.misfits, 1).readings, 0U);
  EXPECT_EQ(outlierShare(CalibrationData{}, {}, 0).readings, 0U);
}
}  // namespace
}  // namespace mrpt_ext
