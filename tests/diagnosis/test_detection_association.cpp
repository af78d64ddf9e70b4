#include "mrpt_ext/diagnosis/detection_association.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_detection_association
{
namespace
{
Landmark landmarkAt(int id, double x, double y) { return {.id = id, .position = {x, y, 0}}; }

/// A robot at the origin that looks along x, known to 5 cm and 1 degree.
GaussianPose robot() { return {{}, Vector3d(square(0.05), square(0.05), square(degToRad(1.0))).asDiagonal()}; }

Detection seenAt(double x, double y)
{
  Detection detection;
  detection.bearing = std::atan2(y, x);
  detection.range = std::hypot(x, y);
  detection.std_bearing = degToRad(1.0);
  detection.std_range = 0.1;
  return detection;
}
}  // namespace

TEST(DetectionAssociation, TakesTheOnlyLandmarkThatIsNear)
{
  const LandmarkTable map({landmarkAt(3, 4, 0), landmarkAt(4, 4, 3)});
  EXPECT_EQ(matchOf(seenAt(4.1, 0), {}, map, robot()).landmark, 0U);
  Detection named = seenAt(4.1, 0);
  named.id = 4;
  EXPECT_EQ(matchOf(named, {}, map, robot()).landmark, 1U);
  const DetectionMatch none = matchOf(seenAt(8, -4), {}, map, robot());
  EXPECT_FALSE(none.landmark);
  EXPECT_TRUE(none.none);
  const LandmarkTable close({landmarkAt(3, 4, 0), landmarkAt(4, 4, 0.2)});
  const DetectionMatch ambiguous = matchOf(seenAt(4, 0.1), {}, close, robot());
  EXPECT_FALSE(ambiguous.landmark);
  EXPECT_FALSE(ambiguous.none);
}

TEST(DetectionAssociation, AMixtureHasTheMeanAndTheVarianceOfItsLandmarks)
{
  const LandmarkTable map({landmarkAt(3, 4, -0.1), landmarkAt(4, 4, 0.1), landmarkAt(5, 4, 3)});
  const auto between = mixtureOf(seenAt(4, 0), {}, map, robot());
  ASSERT_TRUE(between);
  EXPECT_NEAR(between->mean.x(), 4, 1e-12);
  EXPECT_NEAR(between->mean.y(), 0, 1e-12);
  EXPECT_NEAR(between->std_bearing, std::hypot(degToRad(1.0), std::atan(0.1 / 4)), 1e-9);
  EXPECT_NEAR(between->std_range, 0.1, 1e-3) << "both are as far away";
  const auto at_one = mixtureOf(seenAt(4, 0.1), {}, map, robot());
  ASSERT_TRUE(at_one);
  EXPECT_EQ(at_one->likeliest, 1U);
  EXPECT_GT(at_one->mean.y(), 0);
  EXPECT_LT(at_one->mean.y(), 0.1);
}

TEST(DetectionAssociation, OnlyWhatIsMeasuredInPlaceHasAMixture)
{
  const LandmarkTable map({landmarkAt(3, 4, -0.1), landmarkAt(4, 4, 0.1)});
  Detection bearing = seenAt(4, 0);
  bearing.range.reset();
  EXPECT_FALSE(mixtureOf(bearing, {}, map, robot()));
  EXPECT_FALSE(mixtureOf(seenAt(8, -4), {}, map, robot())) << "no landmark is near";
}
}  // namespace mrpt_ext::test_detection_association
