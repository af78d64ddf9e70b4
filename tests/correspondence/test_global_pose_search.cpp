#include "mrpt_ext/correspondence/global_pose_search.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "global_search_scene.h"

namespace mrpt_ext::test_global_pose_search
{
namespace
{
/// Share of robots found, in a square of 10 m where everything is in view.
double shareFound(int landmarks, int seen, int false_detections, bool with_range, int trials)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.area_per_landmark = 100.0 / landmarks;
  options.max_range.reset();
  options.border = 1;
  options.seen = seen;
  options.false_detections = false_detections;
  options.with_range = with_range;
  RandomStream random(6, static_cast<std::uint64_t>(landmarks * 100 + seen));
  int found = 0;
  for (int t = 0; t < trials; ++t)
  {
    const SceneMap map = randomMap(options, random);
    const GlobalPoseSearch search(map.landmarks);
    const SceneScan view = observeSomewhere(map, search.index(), options, random);
    const PoseSearchResult result = search.search({&view.scan, 1}, {});
    // Few bearings can leave a pose uncertain: what counts then is its own covariance.
    found += std::any_of(result.poses.begin(), result.poses.end(),
                         [&](const ConsistentPose& p)
                         {
                           Vector3d e = p.pose.mean.vector() - view.robot.vector();
                           e.z() = wrap(e.z());
                           return isAtTruth(p.pose.mean, view.robot) || e.dot(p.pose.covariance.inverse() * e) < 25;
                         });
  }
  return static_cast<double>(found) / trials;
}
}  // namespace

TEST(GlobalPoseSearch, FewBearingsInASmallMap)
{
  EXPECT_GE(shareFound(12, 4, 0, false, 100), 0.95);
  EXPECT_GE(shareFound(12, 6, 0, false, 100), 0.98);
  EXPECT_GE(shareFound(12, 6, 1, false, 100), 0.97);
}

TEST(GlobalPoseSearch, ManyBearingsInASmallMap) { EXPECT_GE(shareFound(30, 12, 2, false, 40), 0.97); }

TEST(GlobalPoseSearch, PointsInASmallMap)
{
  EXPECT_GE(shareFound(15, 3, 0, true, 100), 0.98);
  EXPECT_GE(shareFound(15, 5, 1, true, 100), 0.98);
}

TEST(GlobalPoseSearch, ATreeThatIsGivenUpSaysSo)
{
  RandomStream random(5);
  std::vector<Landmark> landmarks;
  for (int i = 0; i < 12; ++i) landmarks.push_back({.position = {random.uniform(0, 10), random.uniform(0, 10), 0}});
  const LandmarkTable map(landmarks);
  const Pose2 robot{4, 5, 0.3};
  Scan scan;
  for (std::size_t l = 0; l < 6; ++l)
    scan.detections.push_back({.bearing = predictBearing(robot, map[l].position.head<2>()), .std_bearing = 0.005});
  const GlobalPoseSearch search(map);
  const PoseSearchResult whole = search.search({&scan, 1}, {});
  ASSERT_TRUE(whole.finished && !whole.poses.empty());
  EXPECT_LT((whole.poses.front().pose.mean.position() - robot.position()).norm(), 0.05);
  const PoseSearchResult part = search.search({&scan, 1}, {.max_tree_nodes = 20});
  EXPECT_FALSE(part.finished);
  EXPECT_LT(part.work.tested, whole.work.tested);
}

TEST(GlobalPoseSearch, NothingToGoOnIsAValue)
{
  const GlobalPoseSearch search(LandmarkTable({{.position = {0, 0, 0}}, {.position = {1, 0, 0}}}));
  EXPECT_EQ(search.search({}, {}).status, SolveStatus::too_few);
  Scan scan;
  scan.detections.assign(3, {.bearing = std::numeric_limits<double>::quiet_NaN(), .std_bearing = 0.01});
  EXPECT_EQ(search.search({&scan, 1}, {}).status, SolveStatus::bad_input);
  EXPECT_EQ(GlobalPoseSearch(LandmarkTable()).search({}, {}).status, SolveStatus::too_few);
}
}  // namespace mrpt_ext::test_global_pose_search
