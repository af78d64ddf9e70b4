#include <gtest/gtest.h>

#include <algorithm>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/bearings/direction_intervals.h"
#include "mrpt_ext/correspondence/bearings/search_strategy.h"
#include "mrpt_ext/correspondence/bearings/visibility_vote.h"
#include "test_length.h"

namespace mrpt_ext::test_visibility_vote
{
namespace
{
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
WorkBudget unlimited;

SearchSceneOptions everythingInView(int false_detections)
{
  SearchSceneOptions options;
  options.landmarks = 60;
  options.max_range.reset();
  options.seen = 12;
  options.false_detections = false_detections;
  options.std_bearing = degToRad(0.03);
  return options;
}

struct Scene
{
  SceneMap map;
  LandmarkIndex index;
  Box2 area;

  Scene(const SearchSceneOptions& options, RandomStream& random)
      : map(randomMap(options, random)), index(map.index()), area{{0, 0}, {map.side, map.side}}
  {
  }
};

TEST(DirectionIntervals, CoverWhatIsSeenFromAnywhereInTheDisc)
{
  RandomStream random(1);
  std::vector<Vector2d> landmarks;
  for (int i = 0; i < 300; ++i) landmarks.emplace_back(random.uniform(900, 1100), random.uniform(-100, 100));
  DirectionIntervals seen(landmarks, {1000, 0});
  for (int trial = 0; trial < 50; ++trial)
  {
    const Vector2d point(random.uniform(900, 1100), random.uniform(-100, 100));
    const double radius = random.uniform(0.01, 5), farthest = random.uniform(20, 400);
    seen.update(point, radius, farthest);
    const double direction = random.uniform(-kPi, kPi), r = radius * std::sqrt(random.uniform());
    const Vector2d inside = point + r * Vector2d(std::cos(direction), std::sin(direction));
    for (std::size_t l = 0; l < landmarks.size(); ++l)
    {
      const Vector2d d = landmarks[l] - inside;
      const bool in_range = (landmarks[l] - point).norm() <= farthest - 1e-3;
      if ((landmarks[l] - point).norm() > farthest + 1e-3)
      {
        EXPECT_LT(seen.halfWidth()[l], 0);
      }
      if (in_range)
      {
        EXPECT_LE(std::abs(wrap(std::atan2(d.y(), d.x()) - seen.direction()[l])), seen.halfWidth()[l] + 1e-5);
      }
    }
  }
}

TEST(VisibilityGrid, EveryLandmarkSetsTheBitsOfItsDirectionsOrCountsAsClose)
{
  RandomStream random(2);
  const Scene scene(everythingInView(0), random);
  const auto layout = VisibilityGrid::chooseLayout(scene.index, scene.area, 15, 2);
  ASSERT_TRUE(layout);
  const VisibilityGrid grid(scene.index, *layout);
  int close = 0;
  for (std::size_t cell = 0; cell < layout->cells(); cell += 7)
  {
    const Vector2d half(layout->cell / 2, layout->cell / 2), low = grid.centre(cell) - half;
    const Vector2d point = low + layout->cell * Vector2d(random.uniform(), random.uniform());
    int unseen = 0;
    for (const Vector2d& landmark : scene.index.positions())
    {
      const Vector2d d = landmark - point;
      if (d.norm() > 15) continue;
      const int bin = static_cast<int>(std::floor((std::atan2(d.y(), d.x()) + kTwoPi) / VisibilityGrid::kBinWidth));
      bool seen = true;
      for (int q = bin - VisibilityGrid::kReach + 1; q <= bin; ++q)
      {
        const auto bit = static_cast<std::size_t>((q + VisibilityGrid::kBins) % VisibilityGrid::kBins);
        seen = seen && (grid.ring(cell)[bit / 64] >> (bit % 64) & 1U) != 0;
      }
      if (!seen) ++unseen;
    }
    EXPECT_LE(unseen, grid.closeLandmarks(cell));
    close += grid.closeLandmarks(cell);
  }
  EXPECT_GT(close, 0);  // the case was met
}

TEST(VisibilityGrid, RefusesWhatHasNoGrid)
{
  RandomStream random(2);
  const Scene scene(everythingInView(0), random);
  EXPECT_FALSE(VisibilityGrid::chooseLayout(scene.index, {{0, 0}, {kNoLimit, 1}}, kNoLimit, 2));
  EXPECT_FALSE(VisibilityGrid::chooseLayout(scene.index, {{0, 0}, {0, 1}}, kNoLimit, 2));
  EXPECT_FALSE(VisibilityGrid::chooseLayout(scene.index, {{0, 0}, {1e5, 1e5}}, kNoLimit, 0.01));
  EXPECT_FALSE(VisibilityGrid::chooseLayout(LandmarkIndex(std::vector<Vector2d>{}), scene.area, kNoLimit, 2));
}

class VisibilityVote : public ::testing::TestWithParam<double>  // standard deviation [deg]
{
};

TEST_P(VisibilityVote, TheBoxOfTheTruthSurvivesWhateverIsFalse)
{
  constexpr double kGate = 3.3;
  RandomStream random(3);
  for (int trial = 0; trial < testing::runsOfTest(20); ++trial)
  {
    SearchSceneOptions options = everythingInView(trial % 3);
    options.std_bearing = degToRad(GetParam());
    const Scene scene(options, random);
    const SceneScan view = observeSomewhere(scene.map, scene.index, options, random);
    const std::vector<ScanBearing> bearings = gatherBearings({&view.scan, 1});
    int within = 0;
    for (std::size_t r = 0; r < bearings.size(); ++r)
    {
      if (view.truth[r] < 0) continue;
      const Vector2d d = scene.index.position(static_cast<std::size_t>(view.truth[r])) - view.robot.position();
      const double misfit = wrap(std::atan2(d.y(), d.x()) - view.robot.phi - bearings[r].angle);
      within += std::abs(misfit) <= kGate * bearings[r].std ? 1 : 0;
    }
    const VisibilityGrid grid(scene.index, *VisibilityGrid::chooseLayout(scene.index, scene.area, kNoLimit, 2));
    const PoseBoxes hits = voteForPoses(grid, bearings, kGate, within, 10'000'000, unlimited);
    ASSERT_EQ(hits.floor, within);
    bool found = false;
    for (const auto& level : hits.by_inliers)
      for (const PoseBox& hit : level)
      {
        const Pose2 middle = poseOf(hit, grid, kGate).mean;
        const Vector2d e = (middle.position() - view.robot.position()).cwiseAbs();
        const double turn = std::abs(wrap(middle.phi - view.robot.phi));
        found = found || (e.maxCoeff() <= grid.layout().cell / 2 + 1e-9 &&
                          turn <= VisibilityGrid::kBinWidth / 2 + 1e-9 && hit.inliers >= within);
      }
    EXPECT_TRUE(found) << "trial " << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Deviations, VisibilityVote, ::testing::Values(0.03, 0.1, 0.4));

TEST(VisibilityVote, RaisesTheFloorWhenTooMuchSurvives)
{
  RandomStream random(4);
  const SearchSceneOptions options = everythingInView(0);
  const Scene scene(options, random);
  const SceneScan view = observeSomewhere(scene.map, scene.index, options, random);
  const VisibilityGrid grid(scene.index, *VisibilityGrid::chooseLayout(scene.index, scene.area, kNoLimit, 4));
  const PoseBoxes all = voteForPoses(grid, gatherBearings({&view.scan, 1}), 3.3, 9, 100'000'000, unlimited);
  const PoseBoxes some = voteForPoses(grid, gatherBearings({&view.scan, 1}), 3.3, 9, 5'000, unlimited);
  EXPECT_EQ(all.floor, 9);
  EXPECT_GT(some.floor, 9);
  for (std::size_t level = static_cast<std::size_t>(some.floor); level < all.by_inliers.size(); ++level)
    EXPECT_EQ(some.by_inliers[level].size(), all.by_inliers[level].size());
  for (std::size_t level = 0; level < static_cast<std::size_t>(some.floor); ++level)
    EXPECT_TRUE(some.by_inliers[level].empty());
}

TEST(SearchStrategy, TriplesWhereTheRangeIsShortVoteWhereItIsNot)
{
  RandomStream random(5);
  SearchSceneOptions options = everythingInView(0);
  options.landmarks = 200;
  options.seen = 20;
  const Scene scene(options, random);
  const SceneScan view = observeSomewhere(scene.map, scene.index, options, random);
  const std::vector<ScanBearing> bearings = gatherBearings({&view.scan, 1});
  const TripleEffort few{1e6, 2e5, 20}, many{8e6, 2e6, 200};
  EXPECT_FALSE(chooseVisibilityGrid(scene.index, scene.area, kNoLimit, bearings, 3.3, few, 1, nullptr));
  const auto layout = chooseVisibilityGrid(scene.index, scene.area, kNoLimit, bearings, 3.3, many, 1, nullptr);
  ASSERT_TRUE(layout);
  const auto built = VisibilityGrid::chooseLayout(scene.index, scene.area, kNoLimit, 3);
  EXPECT_EQ(chooseVisibilityGrid(scene.index, scene.area, kNoLimit, bearings, 3.3, many, 1, &*built)->cell,
            built->cell);
  std::vector<ScanBearing> of_a_kind = bearings;
  of_a_kind.front().category = 0;
  EXPECT_FALSE(chooseVisibilityGrid(scene.index, scene.area, kNoLimit, of_a_kind, 3.3, many, 1, nullptr));
}

TEST(BearingSearch, WithoutRangeLimitItCountsOffTheArea)
{
  RandomStream random(6);
  SearchSceneOptions options = everythingInView(1);
  options.landmarks = 200;
  options.seen = 19;
  const Scene scene(options, random);
  const BearingSearch search(scene.index);
  PoseSearchOptions search_options;
  search_options.area = scene.area;
  for (int trial = 0; trial < 6; ++trial)
  {
    const SceneScan view = observeSomewhere(scene.map, scene.index, options, random);
    const PoseSearchResult result = search.search({&view.scan, 1}, search_options);
    ASSERT_FALSE(result.poses.empty());
    EXPECT_TRUE(isAtTruth(result.poses.front().pose.mean, view.robot));
    EXPECT_TRUE(result.unique);
  }
  EXPECT_TRUE(search.tables().builtVisibilityGrid(
      {scene.area.min - Vector2d(0.5, 0.5), scene.area.max + Vector2d(0.5, 0.5)}, kNoLimit));
}
}  // namespace
}  // namespace mrpt_ext::test_visibility_vote
