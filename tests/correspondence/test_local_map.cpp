#include "mrpt_ext/correspondence/local_map/local_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "local_map_truth.h"
#include "test_length.h"

namespace mrpt_ext::test_local_map
{
namespace
{
struct Tally
{
  int points = 0, pure = 0, right = 0, doubled = 0;
  double squared_error = 0;
  std::size_t detections = 0, members = 0, rest = 0;
};

Tally tallyOf(const WindowSceneOptions& options, int trials)
{
  RandomStream random(21);
  Tally tally;
  for (int trial = 0; trial < trials; ++trial)
  {
    const SceneMap map = randomMap(options.scene, random);
    const LandmarkIndex index = map.index();
    const WindowScene view = driveSomewhere(map, index, options, random);
    const LocalLandmarkMap local_map = buildLocalMap(view.scans);
    std::set<int> seen;
    for (const LocalLandmark& point : local_map.points)
    {
      const PointTruth truth = truthOf(point, view, index);
      ++tally.points;
      tally.pure += truth.pure;
      tally.right += truth.right;
      tally.squared_error += truth.pure ? truth.squared_error : 0;
      tally.doubled += truth.pure && !seen.insert(truth.landmark).second;
      tally.members += point.members.size();
    }
    for (const PastScan& p : view.scans) tally.detections += p.scan.detections.size();
    for (const PastScan& p : local_map.rest) tally.rest += p.scan.detections.size();
  }
  return tally;
}

WindowSceneOptions bearingOnly()
{
  WindowSceneOptions options;
  options.scene.landmarks = 200;
  return options;
}
}  // namespace

TEST(LocalLandmarkMap, BearingsAlongAWayBecomePoints)
{
  const int trials = testing::runsOfTest(40);
  const Tally tally = tallyOf(bearingOnly(), trials);
  if (testing::isShort()) return;  // too few trials for the bounds
  EXPECT_GE(tally.points, 10 * trials) << "of about 20 landmarks in view";
  EXPECT_GE(tally.right, 0.93 * tally.points);
  EXPECT_GE(tally.pure, 0.8 * tally.points) << "one wrong sighting among seven hardly moves a point";
  EXPECT_LE(tally.doubled, 0.02 * tally.points);
  EXPECT_NEAR(tally.squared_error / tally.pure, 2, 0.8);
}

TEST(LocalLandmarkMap, RangesAndBearingsOfManyMomentsBecomeOnePointEach)
{
  WindowSceneOptions options = bearingOnly();
  options.scene.with_range = true;
  options.scene.false_detections = 0;
  const int trials = testing::runsOfTest(30);
  const Tally tally = tallyOf(options, trials);
  if (testing::isShort()) return;  // too few trials for the bounds
  EXPECT_GE(tally.points, 15 * trials);
  EXPECT_GE(tally.pure, 0.98 * tally.points);
  EXPECT_LE(tally.doubled, 0.02 * tally.points);
  EXPECT_LE(tally.points, 30 * trials) << "about 20 landmarks in view at a time, 14 seen, 9 times";
  EXPECT_NEAR(tally.squared_error / tally.pure, 2, 0.5);
}

TEST(LocalLandmarkMap, NothingIsLostAndNothingCountedTwice)
{
  for (const bool ranges : {false, true})
  {
    WindowSceneOptions options = bearingOnly();
    options.scene.with_range = ranges;
    const Tally tally = tallyOf(options, testing::runsOfTest(10));
    EXPECT_EQ(tally.members + tally.rest, tally.detections);
  }
}

TEST(LocalLandmarkMap, FalseReadingsAloneHardlyMakePoints)
{
  WindowSceneOptions options = bearingOnly();
  options.scene.detection_probability = 0;
  options.scene.false_detections = 3;
  const int trials = 60;
  EXPECT_LE(tallyOf(options, trials).points, 0.25 * trials);
}

TEST(LocalLandmarkMap, StandingStillGivesNoDistances)
{
  WindowSceneOptions options = bearingOnly();
  options.step = options.turn = 1e-4;
  options.length = 9e-4;
  const Tally tally = tallyOf(options, 20);
  EXPECT_EQ(tally.points, 0);
  EXPECT_EQ(tally.rest, tally.detections);
}

TEST(LocalLandmarkMap, KindsAreNotMixed)
{
  WindowSceneOptions options = bearingOnly();
  options.scene.categories = 3;
  RandomStream random(22);
  const SceneMap map = randomMap(options.scene, random);
  const WindowScene view = driveSomewhere(map, map.index(), options, random);
  const LocalLandmarkMap local_map = buildLocalMap(view.scans);
  EXPECT_GE(local_map.points.size(), 5u);
  for (const LocalLandmark& point : local_map.points)
    for (const auto& m : point.members)
      EXPECT_EQ(view.scans[m.scan].scan.detections[m.detection].category, point.category);
}

TEST(LocalLandmarkMap, OnePlaceStaysAsItIs)
{
  WindowSceneOptions options = bearingOnly();
  options.length = 0;
  options.scene.with_range = true;
  RandomStream random(23);
  const SceneMap map = randomMap(options.scene, random);
  const WindowScene view = driveSomewhere(map, map.index(), options, random);
  const std::vector<Scan> scans = asScans(buildLocalMap(view.scans));
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].detections.size(), view.scans[0].scan.detections.size());
  EXPECT_EQ(scans[0].model.detection_probability, view.scans[0].scan.model.detection_probability);
  EXPECT_TRUE(buildLocalMap({}).rest.empty());
}

TEST(LocalLandmarkMap, ASearchGetsPointsFirstAndTheRestFromItsOwnPlaces)
{
  const WindowSceneOptions options = bearingOnly();
  RandomStream random(24);
  const SceneMap map = randomMap(options.scene, random);
  const LandmarkIndex index = map.index();
  const WindowScene view = driveSomewhere(map, index, options, random);
  const LocalLandmarkMap local_map = buildLocalMap(view.scans);
  const std::vector<Scan> scans = asScans(local_map);
  ASSERT_EQ(scans.size(), local_map.rest.size() + 1);
  ASSERT_EQ(scans[0].detections.size(), local_map.points.size());
  EXPECT_NEAR(*scans[0].model.max_range, 8 + options.length, 0.1);
  for (std::size_t i = 0; i < local_map.points.size(); ++i)
  {
    const AnonymousDetection& d = scans[0].detections[i];
    const Vector2d at = *d.range * Vector2d(std::cos(*d.bearing), std::sin(*d.bearing));
    EXPECT_LT((at - local_map.points[i].in_robot.mean).norm(), 1e-9);
    EXPECT_GE(square(d.std_range) + square(*d.range * d.std_bearing),
              local_map.points[i].in_robot.covariance.trace() * (1 - 1e-9));
  }
  for (std::size_t k = 0; k < local_map.rest.size(); ++k)
  {
    EXPECT_EQ(scans[k + 1].T_robot_sensor.vector(), local_map.rest[k].scan.T_robot_sensor.vector());
    if (local_map.rest[k].odometry_covariance.isZero(0)) continue;
    EXPECT_GT(scans[k + 1].detections[0].std_bearing, options.scene.std_bearing);
    EXPECT_FALSE(scans[k + 1].model.detection_probability);
  }
}
}  // namespace mrpt_ext::test_local_map
