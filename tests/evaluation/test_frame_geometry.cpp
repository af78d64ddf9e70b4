#include "mrpt_ext/evaluation/frame_geometry.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_frame_geometry
{
namespace
{
Frame frameOf(const std::vector<Detection>& detections, const Pose2& T_robot_sensor = {})
{
  Reading reading;
  reading.T_robot_sensor = T_robot_sensor;
  reading.detections = detections;
  Frame frame;
  frame.time = 5;
  frame.readings = {reading};
  return frame;
}

const LandmarkTable kMap({{1, {3, 0, 0}, "", {0, 0}}, {2, {0, 4, 0}, "", {0, 0}}});
const Trajectory kTruth{{5, {0, 0, 0}, true}};
}  // namespace

TEST(AngularSpread, IsTheSmallestAngleAroundAll)
{
  EXPECT_EQ(angularSpread({}), 0);
  EXPECT_EQ(angularSpread({1.0}), 0);
  EXPECT_NEAR(angularSpread({0.5, -0.2}), 0.7, 1e-12);
  EXPECT_NEAR(angularSpread({kPi - 0.1, -kPi + 0.1}), 0.2, 1e-12);
  EXPECT_NEAR(angularSpread({0, kTwoPi / 3, 2 * kTwoPi / 3}), 2 * kTwoPi / 3, 1e-12);
}

TEST(FrameGeometry, OfMeasuredBearingsNeedsNoTruth)
{
  const auto geometry = frameGeometry(frameOf({{.bearing = 0.1}, {.bearing = 1.1}}, {0, 0, 2}), kMap, {}, 0.5);
  ASSERT_TRUE(geometry);
  EXPECT_EQ(geometry->landmarks, 2u);
  EXPECT_NEAR(*geometry->spread, 1.0, 1e-12);
  EXPECT_FALSE(geometry->range);
}

TEST(FrameGeometry, MissingMeasurementsComeFromTheMap)
{
  const auto geometry = frameGeometry(frameOf({{.id = 1, .range = 3}, {.id = 2, .range = 4}}), kMap, kTruth, 0.5);
  ASSERT_TRUE(geometry);
  EXPECT_NEAR(*geometry->spread, kPi / 2, 1e-12);
  EXPECT_NEAR(*geometry->range, 3.5, 1e-12);
}

TEST(FrameGeometry, ALandmarkCountsOnceAndEmptyFramesDoNotCount)
{
  const auto geometry =
      frameGeometry(frameOf({{.id = 1, .bearing = 0.0}, {.id = 1, .bearing = 0.0}}), kMap, kTruth, 0.5);
  ASSERT_TRUE(geometry);
  EXPECT_EQ(geometry->landmarks, 1u);
  EXPECT_FALSE(geometry->spread);
  EXPECT_FALSE(frameGeometry(frameOf({}), kMap, kTruth, 0.5));
}
}  // namespace mrpt_ext::test_frame_geometry
