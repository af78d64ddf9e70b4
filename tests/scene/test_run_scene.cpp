#include "mrpt_ext/scene/run_scene.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_run_scene
{
namespace
{
using namespace scenes;

LandmarkTable twoLandmarks()
{
  Landmark first, second;
  first.id = 1;
  first.position = {0, 0, 0};
  second.id = 2;
  second.position = {4, 3, 0};
  return LandmarkTable({first, second});
}

PlaybackStep aMoment()
{
  PlaybackStep step;
  step.particles = {{1, 1, 0}, {1.1, 1, 0}};
  step.modes = {{{{1, 1, kPi / 2}, 0.01 * Matrix3d::Identity()}, 0.7}, {{{3, 1, 0}, Matrix3d::Identity()}, 0.3}};
  return step;
}

template <typename Shape>
std::size_t countOf(const MrptScene& scene)
{
  std::size_t n = 0;
  while (scene.getByClass<Shape>(n)) ++n;
  return n;
}
}  // namespace

TEST(RunScene, ShowsEveryModeAndTheDetections)
{
  PlaybackStep step = aMoment();
  step.detections = {{{}, 1, 0.0, 2.0, false}, {{}, 2, 0.5, {}, false}};
  const auto scene = runScene(twoLandmarks(), step);
  EXPECT_EQ(countOf<CEllipsoid2D>(*scene), 2U);
  EXPECT_EQ(countOf<CDisk>(*scene), 0U);
  const auto rays = std::dynamic_pointer_cast<CSetOfLines>(scene->getByName("rays"));
  ASSERT_TRUE(rays);
  ASSERT_EQ(rays->size(), 2U);
  // Straight ahead of a robot at (1, 1) that faces +y, two metres away.
  double x0, y0, z0, x1, y1, z1;
  rays->getLineByIndex(0, x0, y0, z0, x1, y1, z1);
  EXPECT_NEAR(x1, 1, 1e-6);
  EXPECT_NEAR(y1, 3, 1e-6);
}

TEST(RunScene, ARangeAloneIsARing)
{
  PlaybackStep step = aMoment();
  step.detections = {{{0.5, 0, 0}, 1, {}, 2.0, false}, {{}, 2, {}, 1.5, true}};
  const auto scene = runScene(twoLandmarks(), step);
  const auto around_sensor = scene->getByClass<CDisk>(0), around_landmark = scene->getByClass<CDisk>(1);
  ASSERT_TRUE(around_sensor && around_landmark);
  EXPECT_NEAR(around_sensor->getPose().x, 1, 1e-6);
  EXPECT_NEAR(around_sensor->getPose().y, 1.5, 1e-6);
  EXPECT_NEAR(around_landmark->getPose().x, 4, 1e-6);
  EXPECT_NEAR(around_landmark->getOutRadius(), 1.52, 1e-6);
}

TEST(RunScene, OfALostRobotHasTheMapOnly)
{
  const auto scene = runScene(twoLandmarks(), {});
  EXPECT_EQ(countOf<CEllipsoid2D>(*scene), 0U);
  EXPECT_EQ(countOf<CSetOfLines>(*scene), 0U);
}

TEST(RunScene, IsWrittenForMrptsViewer)
{
  const testing::ScratchFolder folder;
  writeScene(folder.path() / "a.3Dscene", twoLandmarks(), aMoment());
  MrptScene again;
  ASSERT_TRUE(again.loadFromFile((folder.path() / "a.3Dscene").string()));
  EXPECT_EQ(countOf<CEllipsoid2D>(again), 2U);
  EXPECT_THROW(writeScene(folder.path() / "a.3Dscene" / "b.3Dscene", twoLandmarks(), aMoment()), InputError);
}
}  // namespace mrpt_ext::test_run_scene
