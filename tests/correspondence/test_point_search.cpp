#include "mrpt_ext/correspondence/points/point_search.h"

#include <gtest/gtest.h>

#include <limits>

#include "global_search_scene.h"
#include "probability_calibration.h"

namespace mrpt_ext::test_point_search
{
namespace
{
SearchSceneOptions pointScene(int landmarks)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.with_range = true;
  return options;
}

bool holds(const PoseSearchResult& search, const Pose2& truth)
{
  return std::any_of(search.poses.begin(), search.poses.end(),
                     [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, truth); });
}

/// A sensor that sees these points (robot frame) without error.
Scan seeing(const std::vector<Vector2d>& points, const Pose2& T_robot_sensor = {})
{
  Scan scan;
  scan.T_robot_sensor = T_robot_sensor;
  scan.model.clutter_probability = 0.02;
  for (const Vector2d& point : points)
  {
    const Vector2d d = transform(inverse(T_robot_sensor), point);
    scan.detections.push_back(
        {.bearing = std::atan2(d.y(), d.x()), .range = d.norm(), .std_bearing = 0.01, .std_range = 0.02});
  }
  return scan;
}

std::vector<Vector2d> fromRobot(const Pose2& robot, const std::vector<Vector2d>& landmarks)
{
  std::vector<Vector2d> points;
  for (const Vector2d& l : landmarks) points.push_back(transform(inverse(robot), l));
  return points;
}
}  // namespace

TEST(PointSearch, FindsTheLostRobotInMapsOfEverySize)
{
  for (const int landmarks : {100, 1000, 10000})
  {
    const SearchSceneOptions options = pointScene(landmarks);
    RandomStream random(7, static_cast<std::uint64_t>(landmarks));
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    const PointSearch search(index);
    int found = 0, unique_and_wrong = 0;
    double returned = 0;
    constexpr int kTrials = 200;
    for (int t = 0; t < kTrials; ++t)
    {
      const SceneScan view = observeSomewhere(map, index, options, random);
      const PoseSearchResult result = search.search({&view.scan, 1});
      found += holds(result, view.robot);
      returned += static_cast<double>(result.poses.size()) / kTrials;
      unique_and_wrong += result.unique && !isAtTruth(result.poses.front().pose.mean, view.robot);
      for (const ConsistentPose& p : result.poses) EXPECT_GE(p.log_evidence, result.poses.front().log_evidence - 12);
    }
    EXPECT_GE(found, 0.99 * kTrials) << landmarks;
    EXPECT_LE(returned, 20) << landmarks;
    EXPECT_EQ(unique_and_wrong, 0) << landmarks;
  }
}

TEST(PointSearch, FalsePointsDoNotHideThePose)
{
  SearchSceneOptions options = pointScene(1000);
  options.false_detections = 4;
  RandomStream random(8);
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const PointSearch search(index);
  int found = 0;
  for (int t = 0; t < 100; ++t)
  {
    const SceneScan view = observeSomewhere(map, index, options, random);
    found += holds(search.search({&view.scan, 1}), view.robot);
  }
  EXPECT_GE(found, 98);
}

TEST(PointSearch, ASquareGivesItsFourPosesAlike)
{
  const std::vector<Vector2d> square{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const LandmarkIndex map(square);
  const Pose2 robot{1, 2, 0.4};
  const Scan scan = seeing(fromRobot(robot, square));
  const PoseSearchResult result = PointSearch(map).search({&scan, 1});
  ASSERT_EQ(result.poses.size(), 4u);
  EXPECT_FALSE(result.unique);
  for (const ConsistentPose& pose : result.poses) EXPECT_NEAR(pose.probability, 0.25, 0.01);
  EXPECT_TRUE(holds(result, robot));
}

TEST(PointSearch, TwoPointsGiveEveryPairOfTheirDistance)
{
  const std::vector<Vector2d> landmarks{{0, 0}, {3, 0}, {3, 4}, {10, 10}};
  const LandmarkIndex map(landmarks);
  const Pose2 robot{-1, 1, 2};
  const Scan scan = seeing(fromRobot(robot, {landmarks[0], landmarks[1]}));
  const PoseSearchResult result = PointSearch(map).search({&scan, 1});
  EXPECT_EQ(result.poses.size(), 2u);  // either end may be either landmark
  EXPECT_TRUE(holds(result, robot));
  EXPECT_FALSE(result.unique);
}

TEST(PointSearch, OneOfThreeMayBeFalse)
{
  const std::vector<Vector2d> landmarks{{0, 0}, {3, 0}, {3, 4.5}, {10, 10}, {-5, 7}};
  const LandmarkIndex map(landmarks);
  const Pose2 robot{-1, 1, 2};
  std::vector<Vector2d> points = fromRobot(robot, {landmarks[0], landmarks[2]});
  points.emplace_back(1.3, 9.1);
  const Scan scan = seeing(points);
  EXPECT_TRUE(holds(PointSearch(map).search({&scan, 1}), robot));
}

TEST(PointSearch, PointsOfSeveralPlacesMakeOneConstellation)
{
  const std::vector<Vector2d> landmarks{{0, 0}, {3, 0}, {3, 4.5}, {10, 10}, {-5, 7}};
  const LandmarkIndex map(landmarks);
  const Pose2 robot{-1, 1, 2};
  const std::vector<Vector2d> points = fromRobot(robot, landmarks);
  const std::vector scans{seeing({points[0], points[1]}, {1, 0, 0.3}), seeing({points[1], points[2]}, {-1, 0.5, -2}),
                          seeing({points[4]}, {0, -2, 1})};
  const PoseSearchResult result = PointSearch(map).search(scans);
  ASSERT_FALSE(result.poses.empty());
  EXPECT_TRUE(isAtTruth(result.poses.front().pose.mean, robot));
  EXPECT_EQ(result.poses.front().assignment, (std::vector{0, 1, 1, 2, 4}));
}

TEST(PointSearch, KindsExclude)
{
  const LandmarkTable table({{.position = {0, 0, 0}, .category = "red"},
                             {.position = {3, 0, 0}, .category = "blue"},
                             {.position = {9, 9, 0}, .category = "red"}});
  const LandmarkIndex map(table);
  const Pose2 robot{-1, 1, 2};
  Scan scan = seeing(fromRobot(robot, {{0, 0}, {3, 0}}));
  scan.detections[0].category = map.categoryOf("red");
  scan.detections[1].category = map.categoryOf("blue");
  const PoseSearchResult result = PointSearch(map).search({&scan, 1});
  ASSERT_EQ(result.poses.size(), 1u);
  EXPECT_TRUE(isAtTruth(result.poses.front().pose.mean, robot));
}

TEST(PointSearch, NoPoseIsAValue)
{
  const LandmarkIndex map(std::vector<Vector2d>{{0, 0}, {3, 0}, {3, 4.5}});
  const PointSearch search(map);
  EXPECT_EQ(search.search({}).status, SolveStatus::too_few);
  const Scan one = seeing({{1, 1}}), far = seeing({{0, 0.5}, {50, 1}});
  EXPECT_EQ(search.search({&one, 1}).status, SolveStatus::too_few);
  EXPECT_EQ(search.search({&far, 1}).status, SolveStatus::none);
  Scan broken = seeing({{1, 1}, {2, 3}});
  broken.detections[0].range = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(search.search({&broken, 1}).status, SolveStatus::bad_input);
  const LandmarkIndex empty(std::vector<Vector2d>{});
  const Scan two = seeing({{1, 1}, {2, 3}});
  EXPECT_EQ(PointSearch(empty).search({&two, 1}).status, SolveStatus::none);
}

TEST(PointSearch, TheAreaLimitsThePoses)
{
  const std::vector<Vector2d> square{{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  const LandmarkIndex map(square);
  const Scan scan = seeing(fromRobot({1, 2, 0.4}, square));
  PoseSearchOptions options;
  options.area = Box2{{0, 0}, {3, 3}};
  EXPECT_EQ(PointSearch(map).search({&scan, 1}, options).poses.size(), 1u);
}

TEST(PointSearch, ALatticeIsNeverCalledUnique)
{
  std::vector<Vector2d> lattice;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) lattice.emplace_back(3 * i, 3 * j);
  const LandmarkIndex map(lattice);
  const Pose2 robot{16, 17, 0.2};
  std::vector<Vector2d> near;
  map.forEachNear(robot.position(), 5, [&](std::size_t l) { near.push_back(map.position(l)); });
  const Scan scan = seeing(fromRobot(robot, near));
  const PoseSearchResult result = PointSearch(map).search({&scan, 1});
  EXPECT_TRUE(holds(result, robot));
  EXPECT_GT(result.poses.size(), 50u);
  EXPECT_FALSE(result.unique);
}

TEST(PointSearch, ThreeLandmarksThatAreNoNearNeighboursAreFoundBesideAWrongTriangle)
{
  SearchSceneOptions options = pointScene(300);
  options.max_range = options.border = 6;
  options.detection_probability = 0.25;
  options.std_bearing = degToRad(0.5);
  int met = 0, listed = 0;
  for (std::uint64_t m = 0; m < 4; ++m)
  {
    RandomStream random(77, m);
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    const PointSearch search(index);
    for (int t = 0; t < 50; ++t)
    {
      const SceneScan view = observeSomewhere(map, index, options, random);
      const PoseSearchResult result = search.search({&view.scan, 1}, {});
      const auto seen = std::count_if(view.truth.begin(), view.truth.end(), [](int l) { return l >= 0; });
      if (seen != 3 || result.poses.empty() || result.poses.front().matched != 3) continue;
      ++met;
      listed += std::any_of(result.poses.begin(), result.poses.end(),
                            [&](const ConsistentPose& p) { return isTruthsMode(p, view); });
    }
  }
  EXPECT_GT(met, 20);
  EXPECT_GE(listed, met - met / 20);
}

TEST(PointSearch, AnUnfinishedSearchCallsNothingUnique)
{
  RandomStream random(9);
  const SearchSceneOptions options = pointScene(1000);
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const PointSearch search(index);
  int unfinished = 0;
  for (int t = 0; t < 20; ++t)
  {
    const SceneScan view = observeSomewhere(map, index, options, random);
    WorkBudget budget(1000);
    const PoseSearchResult result = search.search({&view.scan, 1}, {.budget = &budget});
    unfinished += !result.finished;
    EXPECT_FALSE(result.unique && !result.finished);
  }
  EXPECT_GT(unfinished, 0);
}
}  // namespace mrpt_ext::test_point_search
