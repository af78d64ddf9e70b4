#include "mrpt_ext/filter/integrity/outlier_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_outlier_memory
{
namespace
{
const LandmarkClutter kShares{0.05, 0.05};
const OutlierMemory::Outcome kOutlier{0.99, 0.05}, kInlier{0.01, 0.05};
constexpr double kPeriod = 0.1;  // [s]

/// Landmark 0 is outlying in bursts of this mean length [s], or where it is 0 now and then by itself; the last
/// detection was an outlier.
OutlierMemory after(double burst, int detections)
{
  OutlierMemory memory(2);
  RandomStream random(3);
  bool outlying = false;
  for (int k = 0; k < detections; ++k)
  {
    if (burst > 0)
      outlying = random.chance(outlying ? 1 - kPeriod / burst : 0.05 * kPeriod / burst);
    else
      outlying = random.chance(0.05);
    memory.observe("radio", kPeriod * k, 0, k + 1 == detections || outlying ? kOutlier : kInlier);
  }
  return memory;
}
}  // namespace

TEST(OutlierMemory, KnowsTheSharesOnlyAtFirst)
{
  EXPECT_EQ(OutlierMemory(2).predict("radio", 3, kShares), kShares);
  EXPECT_TRUE(OutlierMemory(0).predict("radio", 3, {}).empty());
}

TEST(OutlierMemory, AnOutlierIsFollowedByAnotherOneOfTheSameLandmarkAndSensor)
{
  const OutlierMemory memory = after(4, 3000);
  EXPECT_GT(memory.predict("radio", 300, kShares)[0], 0.9);
  EXPECT_EQ(memory.predict("radio", 300, kShares)[1], 0.05);
  EXPECT_EQ(memory.predict("camera", 300, kShares), kShares);
}

TEST(OutlierMemory, ForgetsAtTheRateAtWhichBurstsEnd)
{
  const double last = 2999.9;
  const OutlierMemory memory = after(4, 30'000);
  EXPECT_NEAR(memory.predict("radio", last + 4, kShares)[0], 0.05 + 0.94 * std::exp(-1 / 0.95), 0.12);
  EXPECT_NEAR(memory.predict("radio", last + 60, kShares)[0], 0.05, 1e-3);
}

TEST(OutlierMemory, OutliersThatComeAloneAreNotRemembered)
{
  EXPECT_LT(after(0, 3000).predict("radio", 300, kShares)[0], 0.5);
}

TEST(OutlierMemory, AnInlierDoesNotMakeTheNextOutlierLessLikely)
{
  OutlierMemory memory(2);
  memory.observe("radio", 1, 0, kInlier);
  EXPECT_EQ(memory.predict("radio", 1.1, kShares), kShares);
}

TEST(OutlierMemory, NeverTakesAnOutlierForCertain)
{
  OutlierMemory memory(2);
  memory.observe("radio", 1, 0, {1, 0.05});
  EXPECT_LE(memory.predict("radio", 1, kShares)[0], 0.95);
  EXPECT_EQ(memory.predict("radio", 1, {0.99, 0.99})[0], 0.99);
}
}  // namespace mrpt_ext::test_outlier_memory
