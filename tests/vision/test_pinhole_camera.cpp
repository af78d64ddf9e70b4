#include "mrpt_ext/vision/tags/pinhole_camera.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_pinhole_camera
{
namespace
{
PinholeCamera wideCamera()
{
  PinholeCamera camera;
  camera.size = {640, 480};
  camera.fx = 440, camera.fy = 450, camera.cx = 321, camera.cy = 238;
  camera.k1 = -0.21, camera.k2 = 0.06, camera.k3 = -0.004, camera.p1 = 6e-4, camera.p2 = -4e-4;
  return camera;
}
}  // namespace

TEST(PinholeCamera, APixelOfOpenCV)
{
  // cv::projectPoints of (0.4, -0.3, 1.2) with these coefficients.
  const auto seen = wideCamera().project({0.4, -0.3, 1.2});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->pixel.x(), 462.46795, 1e-5);
  EXPECT_NEAR(seen->pixel.y(), 129.51109, 1e-5);
}

TEST(PinholeCamera, RaysAndPixelsAreInverse)
{
  const PinholeCamera camera = wideCamera();
  for (const double u : {0.0, 200.0, 639.0})
    for (const double v : {0.0, 300.0, 479.0})
    {
      const auto ray = camera.rayOf({u, v});
      ASSERT_TRUE(ray);
      const auto pixel = camera.project(3 * Eigen::Vector3d(ray->x(), ray->y(), 1));
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->pixel.x(), u, 1e-8);
      EXPECT_NEAR(pixel->pixel.y(), v, 1e-8);
    }
}

TEST(PinholeCamera, TheDerivativeIsThatOfSmallSteps)
{
  const PinholeCamera camera = wideCamera();
  const Eigen::Vector3d point(0.7, -0.4, 1.3);
  const auto seen = camera.project(point);
  ASSERT_TRUE(seen);
  constexpr double kStep = 1e-6;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    const Eigen::Vector2d slope =
        (camera.project(point + step)->pixel - camera.project(point - step)->pixel) / (2 * kStep);
    EXPECT_NEAR((seen->by_point.col(axis) - slope).norm(), 0, 1e-5);
  }
}

TEST(PinholeCamera, NothingBehindItNorWhereTheLensFolds)
{
  PinholeCamera camera = wideCamera();
  EXPECT_FALSE(camera.project({0.1, 0.1, 0}));
  EXPECT_FALSE(camera.project({0.1, 0.1, -1}));
  camera.k1 = -0.4, camera.k2 = camera.k3 = 0;  // turns back at a slope of 0.91
  EXPECT_TRUE(camera.project({0.8, 0, 1}));
  EXPECT_FALSE(camera.project({1.2, 0, 1}));
  EXPECT_FALSE(camera.rayOf({camera.cx + camera.fx, camera.cy}));
}

TEST(PinholeCamera, LevelAxes)
{
  PinholeCamera camera;
  const Eigen::Vector3d ahead(0, 0, 1), right(1, 0, 0);
  EXPECT_NEAR((camera.levelAxes() * ahead - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((camera.levelAxes() * right - Eigen::Vector3d(0, -1, 0)).norm(), 0, 1e-12);
  camera.pitch = degToRad(30);  // down
  EXPECT_NEAR((camera.levelAxes() * ahead).z(), -0.5, 1e-12);
  camera.roll = degToRad(90);  // the right side down: what is right is below the axis
  EXPECT_NEAR((camera.levelAxes() * right).z(), -std::cos(camera.pitch), 1e-12);
  EXPECT_NEAR(camera.levelAxes().determinant(), 1, 1e-12);
}
}  // namespace mrpt_ext::test_pinhole_camera
