#include "mrpt_ext/likelihood/scoring_work.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_scoring_work
{
namespace
{
constexpr double kSide = 100;  // [m] of the map

LandmarkTable landmarks(int count)
{
  RandomStream random(1);
  std::vector<Landmark> all{{.id = 0, .position = {0, 0, 0}}, {.id = 1, .position = {kSide, kSide, 0}}};
  for (int i = 2; i < count; ++i)
    all.push_back({.id = i, .position = {random.uniform(0, kSide), random.uniform(0, kSide), 0}});
  return LandmarkTable(std::move(all));
}

/// Robots in a square of such a side in the middle of the map, with headings within `turn`.
PoseColumns robots(std::size_t count, double side, double turn)
{
  RandomStream random(2);
  PoseColumns columns;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5), phi = random.uniform(-0.5, 0.5);
    columns.add({kSide / 2 + side * x, kSide / 2 + side * y, turn * phi});
  }
  return columns;
}

Frame bearings(std::size_t count, int id = kNoId, std::optional<double> max_range = {})
{
  Reading reading{.sensor = "camera"};
  reading.model.max_range = max_range;
  for (std::size_t d = 0; d < count; ++d) reading.detections.push_back({.id = id, .bearing = 0, .std_bearing = 0.01});
  return {.readings = {reading}};
}
}  // namespace

TEST(ScoringWork, OfRobotsAllOverTheMapEveryLandmarkIsCompared)
{
  const LandmarkTable map = landmarks(1000);
  const PoseColumns spread = robots(512, kSide, kTwoPi);
  EXPECT_DOUBLE_EQ(landmarksCompared({}, map, spread.batch()), 1000);
  EXPECT_NEAR(scoringWork(bearings(20), map, spread.batch()), 20 * 1000.0 * 512, 0.01 * 20 * 1000 * 512);
}

TEST(ScoringWork, OfRobotsCloseTogetherFewLandmarksAreInRangeAndInTheDirection)
{
  const LandmarkTable map = landmarks(1000);
  const PoseColumns close = robots(512, 0.5, 0.1);
  const SensorModel limited{.max_range = 10};
  EXPECT_LT(landmarksCompared({}, map, close.batch()), 100);
  EXPECT_LT(landmarksCompared(limited, map, close.batch()), 5);
  EXPECT_NEAR(shareInRange(limited, map, {20, 0}), 0.4 * 0.2, 1e-9);
  EXPECT_EQ(shareInRange({}, map, {20, 0}), 1);
}

TEST(ScoringWork, AnIdentifiedDetectionIsComparedWithItsLandmarkAlone)
{
  const PoseColumns spread = robots(512, kSide, kTwoPi);
  EXPECT_DOUBLE_EQ(scoringWork(bearings(20, 7), landmarks(1000), spread.batch()), 20.0 * 512);
}

TEST(ScoringWork, ARobotCostsAsMuchAsATileOfThem)
{
  const LandmarkTable map = landmarks(1000);
  const PoseColumns one = robots(1, 0, 0), tile = robots(128, 0, 0);
  EXPECT_DOUBLE_EQ(scoringWork(bearings(20), map, one.batch()), scoringWork(bearings(20), map, tile.batch()));
}

TEST(ScoringWork, ToTellWhichOfManyLandmarksAreInRangeIsWorkToo)
{
  const PoseColumns spread = robots(20'000, kSide, kTwoPi);
  const Frame frame = bearings(1, kNoId, 0.01);
  EXPECT_GT(scoringWork(frame, landmarks(10'000), spread.batch()),
            5 * scoringWork(frame, landmarks(100), spread.batch()));
}

TEST(ScoringWork, NothingToScoreIsNoWork)
{
  EXPECT_EQ(scoringWork({}, landmarks(1000), robots(10, kSide, kTwoPi).batch()), 0);
  EXPECT_EQ(landmarksCompared({}, {}, robots(10, kSide, kTwoPi).batch()), 0);
  EXPECT_EQ(landmarksCompared({}, landmarks(1000), PoseBatch{}), 0);
  EXPECT_EQ(affordableRobots({}, landmarks(1000), robots(10, kSide, kTwoPi).batch(), 10), 10u);
}

TEST(ScoringWork, AUsualFrameIsScoredWhole)
{
  const LandmarkTable map = landmarks(1000);
  const PoseColumns close = robots(20'000, 0.5, 0.1);
  EXPECT_FALSE(affordableToScore(bearings(60, kNoId, 10), map, close.batch()));
  EXPECT_EQ(affordableRobots(bearings(60, kNoId, 10), map, close.batch(), 60), 20'000u);
}

TEST(ScoringWork, WhatIsLeftOfAFrameCanBeScored)
{
  const PoseColumns spread = robots(20'000, kSide, kTwoPi);
  for (const int size : {10, 100, 1000})
    for (const std::size_t count : {10, 400, 5000})
    {
      const LandmarkTable map = landmarks(size);
      const Frame frame = bearings(count);
      const std::optional<Frame> affordable = affordableToScore(frame, map, spread.batch());
      const Frame& scored = affordable ? *affordable : frame;
      EXPECT_EQ(affordable.has_value(), scoringWork(frame, map, spread.batch()) > kMostDensities);
      EXPECT_LE(scoringWork(scored, map, spread.batch()), kMostDensities);
      EXPECT_GE(detectionCount(scored), 1u);
    }
}

TEST(ScoringWork, SomeRobotsCanBeScoredWithTheDetectionsThatAreNeeded)
{
  const LandmarkTable map = landmarks(1000);
  const PoseColumns spread = robots(20'000, kSide, kTwoPi);
  const std::size_t few = affordableRobots(bearings(400), map, spread.batch(), 10);
  EXPECT_NEAR(static_cast<double>(few), kMostDensities / (10 * 1000), 0.01 * kMostDensities / (10 * 1000));
  EXPECT_EQ(affordableRobots(bearings(4), map, spread.batch(), 10), 20'000u) << "4 detections: below the limit";
}
}  // namespace mrpt_ext::test_scoring_work
