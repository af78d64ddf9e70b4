#include "mrpt_ext/correspondence/tree/tree_input.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_tree_input
{
namespace
{
const LandmarkTable kTable({{.id = 1, .position = {0, 0, 0}, .category = "post"},
                            {.id = 2, .position = {4, 0, 0}, .category = "corner"},
                            {.id = 3, .position = {4, 3, 0}, .category = "post"}});
const LandmarkIndex kMap(kTable);

AnonymousDetection bearingOf(double bearing, int category = kAnyCategory, double std = 0.01)
{
  AnonymousDetection d;
  d.bearing = bearing;
  d.std_bearing = std;
  d.category = category;
  return d;
}
}  // namespace

TEST(TreeInput, AsksThePlaceWithMostBearingsThatMayShowALandmark)
{
  AnonymousDetection range;
  range.range = 2;
  std::vector<Scan> scans(3);
  scans[0].detections = {bearingOf(0.1), bearingOf(0.2, kMap.categoryOf("post"), 0.03)};
  scans[1].detections = {bearingOf(1), bearingOf(2)};
  scans[2].detections = {bearingOf(3), bearingOf(4, kUnknownCategory), range};
  const TreeInput newest = scanWithMostBearings(kMap, scans);
  EXPECT_EQ(newest.scan, &scans[1]) << "of several the last";
  const TreeInput first = scanWithMostBearings(kMap, std::span(scans).first(1));
  ASSERT_EQ(first.bearings.size(), 2u);
  EXPECT_TRUE(first.bearings[0].candidates.empty()) << "any landmark";
  EXPECT_EQ(first.bearings[1].candidates, (std::vector<int>{0, 2}));
  EXPECT_EQ(first.std_bearing, 0.03);
  EXPECT_EQ(scanWithMostBearings(kMap, {}).scan, nullptr);
}

TEST(TreeInput, TheSensorMayBeAsFarOutsideAsItSitsFromTheMiddleOfTheRobot)
{
  std::vector<Scan> scans(1);
  scans[0].T_robot_sensor = {0.3, -0.4, 1};
  scans[0].model.max_range = 5;
  scans[0].detections = {bearingOf(0.1)};
  const TreeInput input = scanWithMostBearings(kMap, scans);
  PoseSearchOptions search{.gate = 3, .area = Box2{{0, 0}, {4, 3}}};
  const InterpretationOptions options = treeOptions(input, search);
  ASSERT_TRUE(options.area && options.max_range);
  EXPECT_NEAR((options.area->min - Vector2d(-0.5, -0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((options.area->max - Vector2d(4.5, 3.5)).norm(), 0, 1e-12);
  EXPECT_GT(*options.max_range, 5);
  EXPECT_NEAR(options.max_residual, 0.03, 1e-12);
  EXPECT_EQ(options.max_tested, search.max_tree_nodes);
  EXPECT_EQ(options.budget, nullptr);
  WorkBudget budget(7);
  search.budget = &budget;
  EXPECT_EQ(treeOptions(input, search).budget, &budget);
}

TEST(TreeInput, ThePoseOfTheRobotIsAsUncertainAsThatOfItsSensor)
{
  const Pose2 mount{0.5, 0.2, 0.7};
  const Vector3d std(0.02, 0.03, 0.01);
  const GaussianPose sensor{{2, 1, 2.5}, std.cwiseAbs2().asDiagonal()};
  const GaussianPose robot = robotPose(sensor, mount);
  const Pose2 back = compose(robot.mean, mount);
  EXPECT_NEAR((back.vector() - sensor.mean.vector()).norm(), 0, 1e-12);
  RandomStream random(1);
  Matrix3d scatter = Matrix3d::Zero();
  const int count = 20000;
  for (int k = 0; k < count; ++k)
  {
    const Vector3d n(random.gaussian(), random.gaussian(), random.gaussian());
    const Vector3d drawn = sensor.mean.vector() + std.cwiseProduct(n);
    const Pose2 off = compose({drawn.x(), drawn.y(), drawn.z()}, inverse(mount));
    const Vector3d e(off.x - robot.mean.x, off.y - robot.mean.y, wrap(off.phi - robot.mean.phi));
    scatter += e * e.transpose() / count;
  }
  EXPECT_NEAR((scatter - robot.covariance).norm() / robot.covariance.norm(), 0, 0.05);
}
}  // namespace mrpt_ext::test_tree_input
