#include "mrpt_ext/filter/integrity/pose_verification_test.h"

#include <gtest/gtest.h>

#include "mrpt_ext/hypotheses/pose_region.h"
#include "simulated_run.h"

namespace mrpt_ext
{
namespace
{
const PoseRegion kRegion{{0, 0}, {10, 10}};

ParticleSet particlesAt(const Pose2& pose, RandomStream& random)
{
  ParticleSet particles(Vector2d(5, 5));
  for (int i = 0; i < 300; ++i)
    particles.add({pose.x + 0.03 * random.gaussian(), pose.y + 0.03 * random.gaussian(),
                   pose.phi + degToRad(0.7) * random.gaussian()},
                  0);
  normalizeWeights(particles);
  return particles;
}

/// Log odds of a place `off` the true one after each of `steps` frames of a drive.
std::vector<double> oddsAlong(const SimulatedRobot& robot, const Pose2& off, int steps, std::uint64_t seed)
{
  RandomStream random(seed);
  const LandmarkTable map = randomMap(15, 10, random);
  SequentialPoseTest evidence({}, motionModelOf({}), map);
  Pose2 truth{5, 2, 0};
  std::vector<double> odds;
  for (int k = 0; k < steps; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame(robot, map, truth, roundTripStep(k), random);
    evidence.observe(frame, map, particlesAt(compose(truth, off), random));
    odds.push_back(evidence.logOdds());
  }
  return odds;
}
}  // namespace

TEST(SequentialPoseTest, TheRightPlaceIsProvenByItsLooks)
{
  for (const bool named : {true, false})
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const std::vector<double> odds = oddsAlong({.named = named, .clutter = 0.05}, {}, 60, seed);
      EXPECT_GE(odds.back(), SequentialPoseTestOptions{}.proven) << "named " << named << ", seed " << seed;
    }
}

TEST(SequentialPoseTest, AWrongPlaceIsNotProvenThoughReadingsFitNowAndThen)
{
  int proven = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    RandomStream random(seed, 1);
    const Pose2 off = compose({-1, -1, 0}, kRegion.sample(random));
    for (const double odds : oddsAlong({.named = false, .clutter = 0.05}, off, 60, seed))
      proven += odds >= SequentialPoseTestOptions{}.proven ? 1 : 0;
  }
  EXPECT_EQ(proven, 0);
}

TEST(SequentialPoseTest, AWrongPlaceIsRefuted)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    EXPECT_LE(oddsAlong({.named = true, .clutter = 0.05}, {2, 3, 1}, 30, seed).back(),
              -SequentialPoseTestOptions{}.refuted);
}

TEST(SequentialPoseTest, TheSameSightFromTheSameSpotCountsOnce)
{
  RandomStream random(1);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  Frame frame = simulatedFrame({.detections = 1}, map, truth, {}, random);
  frame.motion = {};
  SequentialPoseTest evidence({}, motionModelOf({}), map);
  evidence.observe(frame, map, particlesAt(truth, random));
  const double once = evidence.logOdds();
  EXPECT_NE(once, 0);
  for (int k = 0; k < 20; ++k) evidence.observe(frame, map, particlesAt(truth, random));
  EXPECT_EQ(evidence.logOdds(), once);
}

TEST(SequentialPoseTest, WhatAPlaceWasChosenByDoesNotCount)
{
  RandomStream random(1);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  const Frame frame = simulatedFrame({}, map, truth, {}, random);
  SequentialPoseTest evidence({}, motionModelOf({}), map);
  evidence.note(frame);
  evidence.observe(frame, map, particlesAt(truth, random));
  EXPECT_EQ(evidence.logOdds(), 0);
}

TEST(SequentialPoseTest, ARichFirstFrameSpeaksForItsPlaceAndProvesNothing)
{
  RandomStream random(3);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  const auto begun = [&](std::size_t detections)
  {
    const Frame frame = simulatedFrame({.measures_range = true, .detections = detections}, map, truth, {}, random);
    ParticleSet samples(Vector2d(5, 5));  // of a proposal that knows the place: weights log(prior / density)
    const double std_xy = 0.05, std_phi = degToRad(1);
    for (int i = 0; i < 4000; ++i)
    {
      const Vector3d n(random.gaussian(), random.gaussian(), random.gaussian());
      const double log_density = -0.5 * n.squaredNorm() - 1.5 * std::log(kTwoPi) - std::log(std_xy * std_xy * std_phi);
      samples.add({truth.x + std_xy * n.x(), truth.y + std_xy * n.y(), truth.phi + std_phi * n.z()},
                  -std::log(kRegion.volume()) - log_density);
    }
    SequentialPoseTest evidence({}, motionModelOf({}), map);
    evidence.begin(frame.readings, map, samples);
    return evidence.logOdds();
  };
  EXPECT_EQ(begun(8), SequentialPoseTestOptions{}.proven / 2);
  EXPECT_LT(begun(1), begun(8));
}

TEST(SequentialPoseTest, WhatWasProvenBeforeABlindSpellHasToBeShownAgain)
{
  const SequentialPoseTestOptions options;
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}});
  const auto after = [&](double blind, double log_odds, bool named = false)
  {
    SequentialPoseTest evidence({.most = log_odds}, motionModelOf({}), map);
    RandomStream random(3);
    const Frame seen = simulatedFrame({.named = named}, map, {5, 2, 0}, {}, random);
    evidence.note(seen);
    evidence.assume();
    evidence.note({.motion = {.duration = blind - 1}});
    EXPECT_EQ(evidence.logOdds(), log_odds) << "nothing is seen yet";
    evidence.note(seen);  // a second later
    return evidence.logOdds();
  };
  EXPECT_EQ(after(options.decay_after, 14), 14);
  EXPECT_NEAR(after(options.decay_after + 10, 14), 14 - 10 * options.decay_per_s, 1e-9);
  EXPECT_LT(after(30, 14), options.proven);
  EXPECT_EQ(after(600, 14), 0) << "that it was wrong is not shown either";
  EXPECT_EQ(after(600, -3), -3);
  EXPECT_EQ(after(600, 14, true), 14) << "a name is not mistaken for another";
}

TEST(SequentialPoseTest, ANameInTheFrameEndsABlindSpellWhateverElseItShows)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {7, 3, 0}}});
  RandomStream random(3);
  const Pose2 truth{5, 2, 0};
  const Reading named = simulatedFrame({}, map, truth, {}, random).readings.front();
  const Reading anonymous = simulatedFrame({.named = false}, map, truth, {}, random).readings.front();
  const ParticleSet particles = particlesAt(truth, random);
  const auto after = [&](const std::vector<Reading>& seen)
  {
    SequentialPoseTest evidence({}, motionModelOf({}), map);
    evidence.assume();
    evidence.note({.motion = {.duration = 600}});
    evidence.observe({.readings = seen}, map, particles);
    return evidence.logOdds();
  };
  EXPECT_GT(after({named, anonymous}), 12);
  EXPECT_GT(after({anonymous, named}), 12);
  EXPECT_GT(after({named}), 12);
  EXPECT_LT(after({anonymous}), SequentialPoseTestOptions{}.proven) << "all that was known is forgotten";
  EXPECT_GT(after({}), 13) << "nothing is seen yet";
}

TEST(SequentialPoseTest, RemembersOnlySoMuch)
{
  RandomStream random(1);
  SequentialPoseTest evidence({}, {}, randomMap(5, 10, random));
  evidence.assume();
  EXPECT_TRUE(evidence.proven());
  EXPECT_EQ(evidence.logOdds(), SequentialPoseTestOptions{}.most);
  evidence.restart();
  EXPECT_FALSE(evidence.proven());
  EXPECT_FALSE(evidence.refuted());
}
}  // namespace mrpt_ext
