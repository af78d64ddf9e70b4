#include <gtest/gtest.h>

#include <algorithm>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/bearings/direction_intervals.h"
#include "mrpt_ext/correspondence/bearings/search_strategy.h"
#include "mrpt_ext/correspondence/bearings/visibility_vote.h"

namespace mrpt_ext
{
namespace
{
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

LostSceneOptions everythingInView(int false_readings)
{
  LostSceneOptions options;
  options.landmarks = 60;
  options.max_range.reset();
  options.seen = 12;
  options.false_readings = false_readings;
  options.std_bearing = degToRad(0.03);
  return options;
}

struct Scene
{
  LostMap map;
  LandmarkIndex index;
  Box2 area;

  Scene(const LostSceneOptions& options, RandomStream& random)
      : map(strewLandmarks(options, random)), index(map.index()), area{{0, 0}, {map.side, map.side}}
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
    const Vector2d place(random.uniform(900, 1100), random.uniform(-100, 100));
    const double radius = random.uniform(0.01, 5), farthest = random.uniform(20, 400);
    seen.lookFrom(place, radius, farthest);
    const double direction = random.uniform(-kPi, kPi), r = radius * std::sqrt(random.uniform());
    const Vector2d inside = place + r * Vector2d(std::cos(direction), std::sin(direction));
    for (std::size_t l = 0; l < landmarks.size(); ++l)
    {
      const Vector2d d = landmarks[l] - inside;
      const bool in_range = (landmarks[l] - place).norm() <= farthest - 1e-3;
      if ((landmarks[l] - place).norm() > farthest + 1e-3)
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

TEST(PanoramaIndex, EveryLandmarkSetsTheBitsOfItsDirectionsOrCountsAsClose)
{
  RandomStream random(2);
  const Scene scene(everythingInView(0), random);
  const auto plan = PanoramaIndex::plan(scene.index, scene.area, 15, 2);
  ASSERT_TRUE(plan);
  const PanoramaIndex panoramas(scene.index, *plan);
  int close = 0;
  for (std::size_t cell = 0; cell < plan->cells(); cell += 7)
  {
    const Vector2d half(plan->cell / 2, plan->cell / 2), low = panoramas.centre(cell) - half;
    const Vector2d place = low + plan->cell * Vector2d(random.uniform(), random.uniform());
    int unseen = 0;
    for (const Vector2d& landmark : scene.index.positions())
    {
      const Vector2d d = landmark - place;
      if (d.norm() > 15) continue;
      const int bin = static_cast<int>(std::floor((std::atan2(d.y(), d.x()) + kTwoPi) / PanoramaIndex::kBinWidth));
      bool seen = true;
      for (int q = bin - PanoramaIndex::kReach + 1; q <= bin; ++q)
      {
        const auto bit = static_cast<std::size_t>((q + PanoramaIndex::kBins) % PanoramaIndex::kBins);
        seen = seen && (panoramas.ring(cell)[bit / 64] >> (bit % 64) & 1U) != 0;
      }
      if (!seen) ++unseen;
    }
    EXPECT_LE(unseen, panoramas.closeLandmarks(cell));
    close += panoramas.closeLandmarks(cell);
  }
  EXPECT_GT(close, 0);  // the case was met
}

TEST(PanoramaIndex, RefusesWhatHasNoGrid)
{
  RandomStream random(2);
  const Scene scene(everythingInView(0), random);
  EXPECT_FALSE(PanoramaIndex::plan(scene.index, {{0, 0}, {kNoLimit, 1}}, kNoLimit, 2));
  EXPECT_FALSE(PanoramaIndex::plan(scene.index, {{0, 0}, {0, 1}}, kNoLimit, 2));
  EXPECT_FALSE(PanoramaIndex::plan(scene.index, {{0, 0}, {1e5, 1e5}}, kNoLimit, 0.01));
  EXPECT_FALSE(PanoramaIndex::plan(LandmarkIndex(std::vector<Vector2d>{}), scene.area, kNoLimit, 2));
}

class PanoramaScan : public testing::TestWithParam<double>  // standard deviation [deg]
{
};

TEST_P(PanoramaScan, TheBoxOfTheTruthSurvivesWhateverIsFalse)
{
  constexpr double kGate = 3.3;
  RandomStream random(3);
  for (int trial = 0; trial < 20; ++trial)
  {
    LostSceneOptions options = everythingInView(trial % 3);
    options.std_bearing = degToRad(GetParam());
    const Scene scene(options, random);
    const LostView view = lookAroundSomewhere(scene.map, scene.index, options, random);
    const std::vector<ScanBearing> readings = gatherBearings({&view.place, 1});
    int within = 0;
    for (std::size_t r = 0; r < readings.size(); ++r)
    {
      if (view.truth[r] < 0) continue;
      const Vector2d d = scene.index.position(static_cast<std::size_t>(view.truth[r])) - view.robot.position();
      const double misfit = wrap(std::atan2(d.y(), d.x()) - view.robot.phi - readings[r].bearing);
      within += std::abs(misfit) <= kGate * readings[r].std ? 1 : 0;
    }
    const PanoramaIndex panoramas(scene.index, *PanoramaIndex::plan(scene.index, scene.area, kNoLimit, 2));
    const PanoramaHits hits = scanPanoramas(panoramas, readings, kGate, within, 10'000'000);
    ASSERT_EQ(hits.floor, within);
    bool found = false;
    for (const auto& level : hits.by_explained)
      for (const PanoramaHit& hit : level)
      {
        const Pose2 middle = poseOf(hit, panoramas, kGate).mean;
        const Vector2d e = (middle.position() - view.robot.position()).cwiseAbs();
        const double turn = std::abs(wrap(middle.phi - view.robot.phi));
        found = found || (e.maxCoeff() <= panoramas.plan().cell / 2 + 1e-9 &&
                          turn <= PanoramaIndex::kBinWidth / 2 + 1e-9 && hit.explained >= within);
      }
    EXPECT_TRUE(found) << "trial " << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Deviations, PanoramaScan, testing::Values(0.03, 0.1, 0.4));

TEST(PanoramaScan, RaisesTheFloorWhenTooMuchSurvives)
{
  RandomStream random(4);
  const LostSceneOptions options = everythingInView(0);
  const Scene scene(options, random);
  const LostView view = lookAroundSomewhere(scene.map, scene.index, options, random);
  const PanoramaIndex panoramas(scene.index, *PanoramaIndex::plan(scene.index, scene.area, kNoLimit, 4));
  const PanoramaHits all = scanPanoramas(panoramas, gatherBearings({&view.place, 1}), 3.3, 9, 100'000'000);
  const PanoramaHits some = scanPanoramas(panoramas, gatherBearings({&view.place, 1}), 3.3, 9, 5'000);
  EXPECT_EQ(all.floor, 9);
  EXPECT_GT(some.floor, 9);
  for (std::size_t level = static_cast<std::size_t>(some.floor); level < all.by_explained.size(); ++level)
    EXPECT_EQ(some.by_explained[level].size(), all.by_explained[level].size());
  for (std::size_t level = 0; level < static_cast<std::size_t>(some.floor); ++level)
    EXPECT_TRUE(some.by_explained[level].empty());
}

TEST(PanoramaChoice, TriplesWhereTheRangeIsShortPanoramasWhereItIsNot)
{
  RandomStream random(5);
  LostSceneOptions options = everythingInView(0);
  options.landmarks = 200;
  options.seen = 20;
  const Scene scene(options, random);
  const LostView view = lookAroundSomewhere(scene.map, scene.index, options, random);
  const std::vector<ScanBearing> readings = gatherBearings({&view.place, 1});
  const TripleEffort few{1e6, 2e5, 20}, many{8e6, 2e6, 200};
  EXPECT_FALSE(choosePanoramas(scene.index, scene.area, kNoLimit, readings, 3.3, few, 1, nullptr));
  const auto plan = choosePanoramas(scene.index, scene.area, kNoLimit, readings, 3.3, many, 1, nullptr);
  ASSERT_TRUE(plan);
  const auto built = PanoramaIndex::plan(scene.index, scene.area, kNoLimit, 3);
  EXPECT_EQ(choosePanoramas(scene.index, scene.area, kNoLimit, readings, 3.3, many, 1, &*built)->cell, built->cell);
  std::vector<ScanBearing> of_a_kind = readings;
  of_a_kind.front().kind = 0;
  EXPECT_FALSE(choosePanoramas(scene.index, scene.area, kNoLimit, of_a_kind, 3.3, many, 1, nullptr));
}

TEST(BearingSearch, WithoutRangeLimitItCountsOffTheArea)
{
  RandomStream random(6);
  LostSceneOptions options = everythingInView(1);
  options.landmarks = 200;
  options.seen = 19;
  const Scene scene(options, random);
  const BearingSearch search(scene.index);
  PoseSearchOptions search_options;
  search_options.area = scene.area;
  for (int trial = 0; trial < 6; ++trial)
  {
    const LostView view = lookAroundSomewhere(scene.map, scene.index, options, random);
    const PoseSearchResult result = search.search({&view.place, 1}, search_options);
    ASSERT_FALSE(result.poses.empty());
    EXPECT_TRUE(isAtTruth(result.poses.front().pose.mean, view.robot));
    EXPECT_TRUE(result.unique);
  }
  EXPECT_TRUE(
      search.builtPanoramas({scene.area.min - Vector2d(0.5, 0.5), scene.area.max + Vector2d(0.5, 0.5)}, kNoLimit));
}
}  // namespace
}  // namespace mrpt_ext
