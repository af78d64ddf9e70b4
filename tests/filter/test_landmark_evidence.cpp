#include "mrpt_ext/filter/integrity/landmark_evidence.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_landmark_evidence
{
TEST(LandmarkEvidence, OfOneLandmarkIsNone)
{
  LandmarkEvidence evidence(14);
  EXPECT_EQ(evidence.add(3, 5), 0);
  EXPECT_EQ(evidence.add(3, 5), 0);
}

TEST(LandmarkEvidence, IsWhatAllButTheStrongestGive)
{
  LandmarkEvidence evidence(14);
  double sum = evidence.add(1, 4);
  sum += evidence.add(2, 6);
  EXPECT_EQ(sum, 4) << "2 leads";
  sum += evidence.add(3, 1);
  EXPECT_EQ(sum, 5);
  sum += evidence.add(1, 5);
  EXPECT_EQ(sum, 7) << "1 leads with 9";
}

TEST(LandmarkEvidence, AgainstAPoseCountsWhole)
{
  LandmarkEvidence evidence(14);
  EXPECT_EQ(evidence.add(1, -3), -3);
  EXPECT_EQ(evidence.add(1, -2), -2);
  EXPECT_EQ(evidence.add(2, 4), 0) << "the rival that fits 2";
}

TEST(LandmarkEvidence, OfALandmarkIsLimited)
{
  LandmarkEvidence evidence(14);
  for (int k = 0; k < 100; ++k) (void)evidence.add(1, 5);
  double sum = evidence.add(2, 5);
  sum += evidence.add(1, -10);
  EXPECT_EQ(sum, 4) << "1 had 14, not 500";
  evidence.restart(false);
  EXPECT_EQ(evidence.add(1, 5), 0);
}

TEST(LandmarkEvidence, OfAPredictedPoseBeginsWithTheFirstDetectionOfEachLandmark)
{
  LandmarkEvidence evidence(14);
  evidence.restart(true);
  EXPECT_EQ(evidence.add(1, 5), 5) << "the pose was there before it";
  EXPECT_EQ(evidence.add(1, 5), 0) << "poses turned about 1 fit as well";
  EXPECT_EQ(evidence.add(2, -3), -3);
  EXPECT_EQ(evidence.add(2, 4), 4) << "1 leads with 5";
}
}  // namespace mrpt_ext::test_landmark_evidence
