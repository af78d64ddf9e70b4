#include <gtest/gtest.h>

#include "../support/synthetic_field.h"

namespace mrpt_ext::test_stereo_camera
{
TEST(StereoCamera, ProjectsAndBackProjects)
{
  const StereoCamera camera = testing::smallCamera();
  for (const double forward : {0.2, 0.7, 1.4})
    for (const double left : {-0.3, 0.0, 0.25})
    {
      const auto pixel = camera.pixelOf({forward, left});
      ASSERT_TRUE(pixel);
      const auto point = camera.floorAt(*pixel);
      ASSERT_TRUE(point);
      EXPECT_NEAR(point->x(), forward, 1e-9);
      EXPECT_NEAR(point->y(), left, 1e-9);
    }
}

TEST(StereoCamera, MeasuresRangeAndBearingWithPitch)
{
  const StereoCamera camera = testing::smallCamera();
  const Eigen::Vector2d point(0.9, 0.3);
  for (const double height : {0.0, 0.03, 0.2})
  {
    const auto left = camera.pixelOf(point, height),
               right = camera.pixelOf(point + Eigen::Vector2d(0, camera.baseline), height);
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(left->y, right->y, 1e-9);
    const auto seen = measureStereo(camera, *left, left->x - right->x, 0.1, 0.2);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->range, point.norm(), 1e-9);
    EXPECT_NEAR(seen->bearing, std::atan2(point.y(), point.x()), 1e-9);
    // Standard deviations against those from small changes of the pixels.
    const double step = 1e-4;
    const auto moved = measureStereo(camera, {left->x + step, left->y}, left->x - right->x, 0.1, 0.2);
    EXPECT_NEAR(seen->std_bearing, std::abs(moved->bearing - seen->bearing) / step * 0.1, 1e-7);
    const auto nearer = measureStereo(camera, *left, left->x - right->x + step, 0.1, 0.2);
    EXPECT_NEAR(seen->std_range, std::abs(nearer->range - seen->range) / step * 0.2, 1e-5);
  }
}

TEST(StereoCamera, RoundsTheDisparityAsThePaperDoes)
{
  StereoCamera camera = testing::smallCamera();
  camera.whole_pixels = true;
  const auto seen = measureStereo(camera, {camera.cx, camera.cy}, 9.4, 0.1, 0.1);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->depth, 1.0, 1e-9);  // 300 * 0.03 / 9
  EXPECT_GT(seen->std_range, seen->range * 0.28 / 9);
  EXPECT_FALSE(measureStereo(camera, {camera.cx, camera.cy}, 0.4, 0.1, 0.1));
}

TEST(StereoCamera, PredictsTheSlopeOfUprightEdges)
{
  const StereoCamera camera = testing::smallCamera();
  const auto foot = camera.pixelOf({0.5, 0.2}), top = camera.pixelOf({0.5, 0.2}, 0.05);
  ASSERT_TRUE(foot && top);
  EXPECT_NEAR(camera.uprightSlope(*foot), (top->x - foot->x) / (top->y - foot->y), 1e-9);
}

TEST(StereoCamera, HasNoFloorPointAboveTheHorizonAndNoPixelBehind)
{
  const StereoCamera camera = testing::smallCamera();
  EXPECT_FALSE(camera.floorAt({160, 20}));
  EXPECT_FALSE(camera.pixelOf({-0.5, 0}));
}
}  // namespace mrpt_ext::test_stereo_camera
