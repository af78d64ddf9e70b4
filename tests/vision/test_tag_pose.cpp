#include "mrpt_ext/vision/tags/tag_pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tag_picture.h"

namespace mrpt_ext::test_tag_pose
{
using testing::PlacedTag;
using testing::wallCamera;

TEST(TagPose, ExactCornersGiveTheExactPose)
{
  PinholeCamera camera = wallCamera();
  camera.k1 = -0.2, camera.k2 = 0.05, camera.p1 = 1e-3;
  for (const double range : {0.6, 2.0, 5.0})
    for (const double turned : {-1.0, -0.3, 0.0, 0.7})
    {
      const PlacedTag tag{.range = range, .bearing = 0.35, .turned = turned};
      const auto poses = posesOfTag(tag.corners(camera), tag.edge, camera, {});
      ASSERT_FALSE(poses.empty());
      const Eigen::Vector3d level = camera.levelAxes() * poses[0].centre;
      EXPECT_NEAR(level.head<2>().norm(), range, 1e-6);
      EXPECT_NEAR(std::atan2(level.y(), level.x()), tag.bearing, 1e-8);
      EXPECT_NEAR(level.z(), tag.above, 1e-6);
      EXPECT_LT(poses[0].residual, 1e-10);
      EXPECT_NEAR(poses[0].rotation.determinant(), 1, 1e-9);
    }
}

TEST(TagPose, AnyAttitudeWhereTagsHangAnyhow)
{
  const PinholeCamera camera = wallCamera();
  TagCorners corners;
  const Eigen::Matrix3d attitude =
      (Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ())).matrix();
  const Eigen::Vector3d centre(0.2, -0.1, 1.5);
  const std::array<Eigen::Vector3d, 4> arms{Eigen::Vector3d(-1, 1, 0), {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = camera.project(centre + attitude * (0.1 * arms[i]))->pixel;
  const auto anyhow = posesOfTag(corners, 0.2, camera, {.std_corner = 0.5, .std_upright = 10});
  ASSERT_FALSE(anyhow.empty());
  EXPECT_LT((anyhow[0].centre - centre).norm(), 1e-3);
  EXPECT_LT(anyhow[0].residual, 0.1);
  EXPECT_GT(posesOfTag(corners, 0.2, camera, {}).at(0).residual, 25);
}

TEST(TagPose, EitherWayAroundAndFromEveryCorner)
{
  const PinholeCamera camera = wallCamera();
  const TagCorners corners = PlacedTag{.bearing = -0.2}.corners(camera);
  const Eigen::Vector3d centre = posesOfTag(corners, 0.2, camera, {}).at(0).centre;
  const TagCorners turned{corners[2], corners[3], corners[0], corners[1]},
      reversed{corners[3], corners[2], corners[1], corners[0]};
  EXPECT_NEAR((posesOfTag(turned, 0.2, camera, {}).at(0).centre - centre).norm(), 0, 1e-6);
  EXPECT_NEAR((posesOfTag(reversed, 0.2, camera, {}).at(0).centre - centre).norm(), 0, 1e-6);
}

TEST(TagPose, FarAwayASecondOneExplainsTheCornersNearlyAsWell)
{
  const PinholeCamera camera = wallCamera();
  const PlacedTag tag{.range = 5, .turned = 0.5};
  const auto poses = posesOfTag(tag.corners(camera), tag.edge, camera, {});
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_GT(poses[1].residual, poses[0].residual);
  EXPECT_LT(poses[1].residual, 4);
  EXPECT_GT((poses[1].rotation.col(2) - poses[0].rotation.col(2)).norm(), 0.5);
  EXPECT_LT((poses[1].centre - poses[0].centre).norm(), 0.02);
}

TEST(TagPose, CornersOfNoSquareGiveNone)
{
  const PinholeCamera camera = wallCamera();
  const auto none = [&](const TagCorners& corners) { return posesOfTag(corners, 0.2, camera, {}).empty(); };
  EXPECT_TRUE(none({Eigen::Vector2d(100, 100), {100, 100}, {100, 100}, {100, 100}}));
  EXPECT_TRUE(none({Eigen::Vector2d(100, 100), {150, 100}, {200, 100}, {250, 100}}));
  EXPECT_TRUE(none({Eigen::Vector2d(100, 100), {200, 100}, {130, 130}, {100, 200}}));  // an arrow head
  EXPECT_TRUE(none({Eigen::Vector2d(100, 100), {200, 200}, {200, 100}, {100, 200}}));  // crossed
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(none({Eigen::Vector2d(nan, 100), {200, 100}, {200, 200}, {100, 200}}));
}
}  // namespace mrpt_ext::test_tag_pose
