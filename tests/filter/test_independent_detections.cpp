#include "mrpt_ext/filter/integrity/independent_detections.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
namespace
{
constexpr double kSpacing = 0.3;

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

class FreshLooksTest : public testing::Test
{
 protected:
  std::size_t freshOf(const Reading& reading) { return looks_.take(reading).detections.size(); }

  DetectionDecorrelator looks_{
      {.longest = kSpacing}, {.std_phi_per_deg = 0, .std_phi_per_m = 0, .std_phi_per_s = 0}, bigMap()};
};
}  // namespace

TEST_F(FreshLooksTest, TheSameDirectionFromTheSameSpotIsARepeat)
{
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(freshOf(readingOf({0.5})), 0U);
  EXPECT_EQ(freshOf(readingOf({0.5, 1.0})), 1U);
}

TEST_F(FreshLooksTest, APieceOfWayMakesItFresh)
{
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
  looks_.move(motionBy({0.6 * kSpacing, 0, 0}));
  EXPECT_EQ(freshOf(readingOf({0.5})), 0U);
  looks_.move(motionBy({0.6 * kSpacing, 0, 0}));
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
}

TEST_F(FreshLooksTest, TurningOnTheSpotShowsNothingNew)
{
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
  looks_.move(motionBy({0, 0, 0.4}));
  EXPECT_EQ(freshOf(readingOf({0.1})), 0U);
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
}

TEST_F(FreshLooksTest, SensorsAndNamesAreApart)
{
  EXPECT_EQ(freshOf(readingOf({0.5})), 1U);
  EXPECT_EQ(freshOf(readingOf({0.5}, 1)), 1U);
  Reading other = readingOf({0.5});
  other.sensor = "second";
  EXPECT_EQ(freshOf(other), 1U);
}

TEST_F(FreshLooksTest, OnlyRepeatsWithoutANameAreLeftOut)
{
  const Reading first = looks_.withoutCorrelatedBearings(readingOf({0.5}));
  EXPECT_EQ(first.detections.size(), 1U);
  EXPECT_TRUE(first.model.detection_probability) << "nothing is left out: the reading is whole";
  const Reading second = looks_.withoutCorrelatedBearings(readingOf({0.5, 1.5}));
  ASSERT_EQ(second.detections.size(), 1U);
  EXPECT_EQ(second.detections.front().bearing, 1.5);
  EXPECT_FALSE(second.model.detection_probability) << "what was missed is told by whole readings";
  for (int k = 0; k < 3; ++k) EXPECT_EQ(looks_.withoutCorrelatedBearings(readingOf({0.5}, 1)).detections.size(), 1U);
}
}  // namespace mrpt_ext
