#include "mrpt_ext/filter/integrity/independent_detections.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_independent_detections
{
namespace
{
constexpr double kDistance = 0.3;  // [m] the decorrelator's, in a large map

LandmarkTable bigMap() { return LandmarkTable({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {30, 30, 0}}}); }

Reading readingOf(std::vector<double> bearings, int id = kNoId)
{
  Reading reading;
  reading.sensor = "camera";
  reading.model.detection_probability = 0.9;
  for (const double bearing : bearings)
    reading.detections.push_back({.id = id, .bearing = bearing, .std_bearing = degToRad(1)});
  return reading;
}

OdometryMotion motionBy(const Pose2& increment)
{
  return {.increment = increment,
          .path_length = increment.position().norm(),
          .turned = std::abs(increment.phi),
          .duration = 1};
}

class IndependentDetectionsTest : public ::testing::Test
{
 protected:
  std::size_t independentOf(const Reading& reading) { return decorrelator_.independent(reading).detections.size(); }

  DetectionDecorrelator decorrelator_{{.std_phi_per_deg = 0, .std_phi_per_m = 0, .std_phi_per_s = 0}, bigMap()};
};
}  // namespace

TEST_F(IndependentDetectionsTest, TheSameDirectionFromTheSameSpotIsCorrelated)
{
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(independentOf(readingOf({0.5})), 0U);
  EXPECT_EQ(independentOf(readingOf({0.5, 1.0})), 1U);
}

TEST_F(IndependentDetectionsTest, ADistanceMakesItIndependent)
{
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
  decorrelator_.move(motionBy({0.6 * kDistance, 0, 0}));
  EXPECT_EQ(independentOf(readingOf({0.5})), 0U);
  decorrelator_.move(motionBy({0.6 * kDistance, 0, 0}));
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
}

TEST_F(IndependentDetectionsTest, RotationOnTheSpotGivesNothingNew)
{
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
  decorrelator_.move(motionBy({0, 0, 0.4}));
  EXPECT_EQ(independentOf(readingOf({0.1})), 0U);
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
}

TEST_F(IndependentDetectionsTest, SensorsAndIdentitiesAreIndependent)
{
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
  EXPECT_EQ(independentOf(readingOf({0.5}, 1)), 1U);
  Reading other = readingOf({0.5});
  other.sensor = "second";
  EXPECT_EQ(independentOf(other), 1U);
}

TEST_F(IndependentDetectionsTest, OnlyCorrelatedAnonymousBearingsAreLeftOut)
{
  const Reading first = decorrelator_.withoutCorrelatedBearings(readingOf({0.5}));
  EXPECT_EQ(first.detections.size(), 1U);
  EXPECT_TRUE(first.model.detection_probability) << "nothing is left out: the reading is whole";
  const Reading second = decorrelator_.withoutCorrelatedBearings(readingOf({0.5, 1.5}));
  ASSERT_EQ(second.detections.size(), 1U);
  EXPECT_EQ(second.detections.front().bearing, 1.5);
  EXPECT_FALSE(second.model.detection_probability) << "only whole readings show what was missed";
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(decorrelator_.withoutCorrelatedBearings(readingOf({0.5}, 1)).detections.size(), 1U);
}

TEST_F(IndependentDetectionsTest, AReadingIsSplitInTwo)
{
  EXPECT_EQ(independentOf(readingOf({0.5})), 1U);
  const auto [independent, correlated] = decorrelator_.split(readingOf({0.5, 1.5, 0.51}));
  ASSERT_EQ(independent.detections.size(), 1U);
  EXPECT_EQ(independent.detections[0].bearing, 1.5);
  ASSERT_EQ(correlated.detections.size(), 2U);
  EXPECT_EQ(correlated.detections[1].bearing, 0.51);
  EXPECT_FALSE(correlated.model.detection_probability);
}

TEST_F(IndependentDetectionsTest, TheDistanceIsShorterInASmallMap)
{
  const LandmarkTable small({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {3, 4, 0}}});  // 2 %: 0.1 m
  DetectionDecorrelator decorrelator({.std_phi_per_deg = 0, .std_phi_per_m = 0, .std_phi_per_s = 0}, small);
  EXPECT_EQ(decorrelator.independent(readingOf({0.5})).detections.size(), 1U);
  decorrelator.move(motionBy({0.09, 0, 0}));
  EXPECT_EQ(decorrelator.independent(readingOf({0.5})).detections.size(), 0U);
  decorrelator.move(motionBy({0.02, 0, 0}));
  EXPECT_EQ(decorrelator.independent(readingOf({0.5})).detections.size(), 1U);
}
}  // namespace mrpt_ext::test_independent_detections
