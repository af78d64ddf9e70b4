#include "mrpt_ext/correspondence/bearings/bearing_search.h"

#include <gtest/gtest.h>

#include <limits>

#include "global_search_scene.h"
#include "test_length.h"

namespace mrpt_ext::test_bearing_search
{
namespace
{
bool findsTruth(const PoseSearchResult& search, const Pose2& truth)
{
  return std::any_of(search.poses.begin(), search.poses.end(),
                     [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, truth); });
}

PoseSearchResult searchOne(const LandmarkIndex& index, const Scan& scan, const PoseSearchOptions& options = {})
{
  return BearingSearch(index).search({&scan, 1}, options);
}

struct Tally
{
  int trials = 0, found = 0, unique = 0, unique_wrong = 0, too_unlikely = 0;
  double poses = 0;
};

Tally run(const SearchSceneOptions& options, int trials, std::uint64_t seed)
{
  trials = testing::runsOfTest(trials);
  RandomStream random(seed);
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const BearingSearch search(index);
  Tally tally;
  for (; tally.trials < trials; ++tally.trials)
  {
    const SceneScan view = observeSomewhere(map, index, options, random);
    const PoseSearchResult found = search.search({&view.scan, 1});
    tally.found += findsTruth(found, view.robot);
    tally.poses += static_cast<double>(found.poses.size()) / trials;
    tally.unique += found.unique;
    tally.unique_wrong += found.unique && !isAtTruth(found.poses.front().pose.mean, view.robot);
    for (const ConsistentPose& p : found.poses)
      tally.too_unlikely += p.log_likelihood < found.poses.front().log_likelihood - 12.5;
  }
  return tally;
}

TEST(BearingSearch, FindsTheRobotAmongAThousandLandmarks)
{
  const Tally tally = run({}, 60, 11);
  EXPECT_GE(tally.found, tally.trials - 1);
  EXPECT_LE(tally.poses, 20);
  EXPECT_GE(tally.unique, 3 * tally.trials / 4);
  EXPECT_EQ(tally.unique_wrong, 0);
}

TEST(BearingSearch, KindsAreUsed)
{
  SearchSceneOptions options;
  options.categories = 4;
  const Tally tally = run(options, 100, 12);
  EXPECT_GE(tally.found, tally.trials - 1);
  EXPECT_EQ(tally.unique_wrong, 0);
}

TEST(BearingSearch, ThreeFalseReadingsOfSixteen)
{
  SearchSceneOptions options;
  options.detection_probability = 0.8;
  options.false_detections = 3;
  const Tally tally = run(options, 30, 13);
  EXPECT_GE(tally.found, tally.trials - 1);
  EXPECT_EQ(tally.unique_wrong, 0);
}

TEST(BearingSearch, WithoutARangeLimit)
{
  SearchSceneOptions options;
  options.landmarks = 40;
  options.max_range.reset();
  options.seen = 12;
  options.border = 2;
  options.std_bearing = degToRad(0.05);
  const Tally tally = run(options, 10, 14);
  EXPECT_GE(tally.found, tally.trials - 1);
}

TEST(BearingSearch, AFarAwayMapCostsNoDigits)
{
  SearchSceneOptions options;
  options.landmarks = 300;
  RandomStream random(15);
  const SceneMap map = randomMap(options, random);
  std::vector<Vector2d> moved;
  const Vector2d offset(4e6, -2e6);
  for (const Landmark& l : map.landmarks.all()) moved.push_back(l.position.head<2>() + offset);
  const LandmarkIndex near(map.landmarks), far(moved);
  const SceneScan view = observeSomewhere(map, near, options, random);
  const PoseSearchResult here = searchOne(near, view.scan), there = searchOne(far, view.scan);
  ASSERT_FALSE(here.poses.empty());
  ASSERT_FALSE(there.poses.empty());
  const Pose2 a = here.poses.front().pose.mean, b = there.poses.front().pose.mean;
  EXPECT_LT((a.position() + offset - b.position()).norm(), 1e-3);
  EXPECT_LT(std::abs(wrap(a.phi - b.phi)), 1e-4);
}

TEST(BearingSearch, TwoSensorsHelpEachOther)
{
  SearchSceneOptions options;
  options.detection_probability = 0.35;  // each alone sees about seven
  RandomStream random(16);
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const BearingSearch search(index);
  int found = 0, unique = 0;
  const int trials = testing::runsOfTest(15);
  for (int t = 0; t < trials; ++t)
  {
    const Pose2 robot{random.uniform(20, 80), random.uniform(20, 80), random.uniform(-kPi, kPi)};
    const Scan scans[] = {observe(map, index, options, robot, random, {0.3, 0.2, 0.5}).scan,
                          observe(map, index, options, robot, random, {-0.4, 0.1, -2}).scan};
    const PoseSearchResult result = search.search(scans);
    found += findsTruth(result, robot);
    unique += result.unique;
  }
  EXPECT_GE(found, trials - 1);
  EXPECT_GE(unique, trials / 2);
}

TEST(BearingSearch, TheSameAnswerTwice)
{
  RandomStream random(17);
  const SearchSceneOptions options;
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const SceneScan view = observeSomewhere(map, index, options, random);
  const PoseSearchResult a = searchOne(index, view.scan), b = searchOne(index, view.scan);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i)
  {
    EXPECT_EQ(a.poses[i].pose.mean.vector(), b.poses[i].pose.mean.vector());
    EXPECT_EQ(a.poses[i].log_evidence, b.poses[i].log_evidence);
  }
  EXPECT_EQ(a.work.tested, b.work.tested);
}

TEST(BearingSearch, ProbabilitiesLeaveRoomForTheRest)
{
  RandomStream random(18);
  SearchSceneOptions options;
  options.detection_probability = 0.4;
  options.std_bearing = degToRad(0.3);
  options.landmarks = 300;
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  for (int t = 0; t < testing::runsOfTest(4); ++t)
  {
    const PoseSearchResult found = searchOne(index, observeSomewhere(map, index, options, random).scan);
    double sum = found.probability_elsewhere;
    for (const ConsistentPose& p : found.poses) sum += p.probability;
    EXPECT_NEAR(sum, 1, 1e-9);
    EXPECT_FALSE(found.unique && found.expected_false > 0.05);
  }
}

TEST(BearingSearch, SaysWhatIsWrongWithItsInput)
{
  RandomStream random(19);
  const SearchSceneOptions options;
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index(), empty{std::vector<Vector2d>{}};
  Scan scan = observeSomewhere(map, index, options, random).scan;
  EXPECT_EQ(searchOne(empty, scan).status, SolveStatus::none);
  Scan two = scan;
  two.detections.resize(2);
  EXPECT_EQ(searchOne(index, two).status, SolveStatus::too_few);
  EXPECT_EQ(BearingSearch(index).search({}).status, SolveStatus::too_few);
  Scan unknown = scan;
  for (AnonymousDetection& d : unknown.detections) d.category = kUnknownCategory;
  EXPECT_EQ(searchOne(index, unknown).status, SolveStatus::too_few);
  scan.detections.front().bearing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(searchOne(index, scan).status, SolveStatus::bad_input);
  scan.detections.front().bearing = 0.5;
  scan.detections.front().std_bearing = 0;
  EXPECT_EQ(searchOne(index, scan).status, SolveStatus::bad_input);
}

TEST(BearingSearch, LandmarksOnALineAndRepeatedBearings)
{
  std::vector<Vector2d> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(i, 0);
  const LandmarkIndex index(line);
  Scan scan;
  scan.model.max_range = 8;
  for (const double b : {0.1, 0.1, 0.6, 1.2, 2.0, 2.0})
  {
    AnonymousDetection d;
    d.bearing = b;
    d.std_bearing = degToRad(0.5);
    scan.detections.push_back(d);
  }
  const PoseSearchResult found = searchOne(index, scan);
  for (const ConsistentPose& p : found.poses) EXPECT_TRUE(isFinite(p.pose.mean));
  EXPECT_FALSE(found.unique);
}

TEST(BearingSearch, ALatticeIsAmbiguous)
{
  std::vector<Vector2d> lattice;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) lattice.emplace_back(3 * i, 3 * j);
  const LandmarkIndex index(lattice);
  const SceneMap map{57, LandmarkTable{}};
  SearchSceneOptions options;
  options.detection_probability = 1;
  options.false_detections = 0;
  options.max_range = 6;
  RandomStream random(20);
  const SceneScan view = observe(map, index, options, {28.3, 29.1, 0.7}, random);
  PoseSearchOptions few;
  few.max_poses = 50;
  const PoseSearchResult found = searchOne(index, view.scan, few);
  EXPECT_GT(found.poses.size(), 20u);
  EXPECT_LE(found.poses.size(), 50u);
  EXPECT_FALSE(found.unique);
  EXPECT_LT(found.poses.front().probability, 0.1);
}

TEST(BearingSearch, StopsWhenToldTo)
{
  RandomStream random(21);
  const SearchSceneOptions options;
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  WorkBudget budget(1000);
  const PoseSearchOptions hurried{.budget = &budget};
  const PoseSearchResult found = searchOne(index, observeSomewhere(map, index, options, random).scan, hurried);
  EXPECT_FALSE(found.finished);
  EXPECT_FALSE(found.unique);
}
}  // namespace
}  // namespace mrpt_ext::test_bearing_search
