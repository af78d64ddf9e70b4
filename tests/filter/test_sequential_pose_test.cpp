#include "mrpt_ext/filter/integrity/sequential_pose_test.h"

#include <gtest/gtest.h>

#include "mrpt_ext/hypotheses/pose_region.h"
#include "simulated_run.h"

namespace mrpt_ext::test_sequential_pose_test
{
namespace
{
const PoseRegion kRegion{{0, 0}, {10, 10}};

/// Log odds of a pose `off` the true one after each of `steps` frames of a drive.
std::vector<double> oddsAlong(const SimulatedRobot& robot, const Pose2& off, int steps, std::uint64_t seed)
{
  RandomStream random(seed);
  const LandmarkTable map = randomMap(15, 10, random);
  SequentialPoseTest test(motionModelOf({}), map);
  Pose2 truth{5, 2, 0};
  std::vector<double> odds;
  for (int k = 0; k < steps; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame(robot, map, truth, roundTripStep(k), random);
    test.update(frame, map, particlesAt(compose(truth, off), random));
    odds.push_back(test.logOdds());
  }
  return odds;
}
}  // namespace

TEST(SequentialPoseTest, TheRightPoseIsVerifiedByItsDetections)
{
  for (const bool identified : {true, false})
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      const std::vector<double> odds = oddsAlong({.identified = identified, .clutter = 0.05}, {}, 60, seed);
      EXPECT_GE(odds.back(), SequentialPoseTest::kAcceptLogOdds) << "identified " << identified << ", seed " << seed;
    }
}

TEST(SequentialPoseTest, AWrongPoseIsNotVerifiedThoughSomeReadingsFit)
{
  int verified = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    RandomStream random(seed, 1);
    const Pose2 off = compose({-1, -1, 0}, kRegion.sample(random));
    for (const double odds : oddsAlong({.identified = false, .clutter = 0.05}, off, 60, seed))
      verified += odds >= SequentialPoseTest::kAcceptLogOdds ? 1 : 0;
  }
  EXPECT_EQ(verified, 0);
}

TEST(SequentialPoseTest, AWrongPoseIsRefuted)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    EXPECT_LE(oddsAlong({.identified = true, .clutter = 0.05}, {2, 3, 1}, 30, seed).back(),
              SequentialPoseTest::kRejectLogOdds);
}

TEST(SequentialPoseTest, TheSameDetectionFromTheSameSpotCountsOnce)
{
  RandomStream random(1);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  Frame frame = simulatedFrame({.detections = 2}, map, truth, {}, random);
  frame.motion = {};
  SequentialPoseTest test(motionModelOf({}), map);
  test.update(frame, map, particlesAt(truth, random));
  const double once = test.logOdds();
  EXPECT_NE(once, 0);
  for (int k = 0; k < 20; ++k) test.update(frame, map, particlesAt(truth, random));
  EXPECT_EQ(test.logOdds(), once);
}

// While the robot stands its true detections repeat themselves; every false number is one that was not seen there yet.
TEST(SequentialPoseTest, FalseDetectionsOfAStopDoNotRefuteThePose)
{
  RandomStream random(1);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  SimulatedRobot robot{.measures_range = true, .detections = 8, .clutter = 0.05};
  SequentialPoseTest test(motionModelOf({}), map);
  test.accept();
  Frame frame = simulatedFrame(robot, map, truth, {}, random);
  const std::vector<Detection> seen = frame.readings.front().detections;
  for (int k = 0; k < 100; ++k)
  {
    frame.motion = {};
    frame.readings.front().detections = seen;
    Detection clutter = seen.front();
    if (k % 10 == 9) clutter.id = map[random.below(map.size())].id, clutter.bearing = random.uniform(-kPi, kPi);
    frame.readings.front().detections.push_back(clutter);
    test.update(frame, map, particlesAt(truth, random));
    EXPECT_TRUE(test.verified()) << "reading " << k;
  }
}

TEST(SequentialPoseTest, OneLandmarkAloneVerifiesNoPose)
{
  const LandmarkTable map(
      {{.id = 1, .position = {2, 2, 0}, .category = "post"}, {.id = 2, .position = {7, 3, 0}, .category = "cone"}});
  const auto drive = [&](std::size_t detections, bool compass, bool identified = true, bool categories = true)
  {
    RandomStream random(4);
    SequentialPoseTest test(motionModelOf({}), map);
    Pose2 truth{5, 2, 0};
    for (int k = 0; k < 60; ++k)
    {
      truth = compose(truth, roundTripStep(k));
      Frame frame = simulatedFrame({.measures_range = true}, map, truth, roundTripStep(k), random);
      for (Reading& reading : frame.readings)
      {
        std::erase_if(reading.detections, [&](const Detection& d) { return d.id > static_cast<int>(detections); });
        for (Detection& d : reading.detections)
        {
          if (categories) d.category = d.id == 1 ? "post" : "cone";
          d.id = identified ? d.id : kNoId;
        }
      }
      if (compass) frame.compass = CompassRecord{.heading = truth.phi, .std_heading = 0.1};
      test.update(frame, map, particlesAt(truth, random));
    }
    return test.logOdds();
  };
  EXPECT_LT(drive(1, false), 1);
  EXPECT_GE(drive(2, false), SequentialPoseTest::kAcceptLogOdds);
  EXPECT_GE(drive(1, true), SequentialPoseTest::kAcceptLogOdds) << "the heading is known";
  EXPECT_LT(drive(1, false, false), SequentialPoseTest::kAcceptLogOdds) << "anonymous";
  EXPECT_GE(drive(2, false, false), SequentialPoseTest::kAcceptLogOdds);
  EXPECT_EQ(drive(2, false, false, false), 0) << "the map looks the same from the other side";
}

TEST(SequentialPoseTest, OneLandmarkThatFacesAKnownDirectionVerifiesAPose)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}, .yaw = 0.5}});
  const auto drive = [&](double other_weight)
  {
    RandomStream random(4);
    SequentialPoseTest test(motionModelOf({}), map);
    Pose2 truth{5, 2, 0};
    for (int k = 0; k < 60; ++k)
    {
      truth = compose(truth, roundTripStep(k));
      Frame frame = simulatedFrame({.measures_range = true}, map, truth, roundTripStep(k), random);
      for (Reading& reading : frame.readings)
        for (Detection& d : reading.detections)
        {
          const double yaw = wrap(0.5 - truth.phi - reading.T_robot_sensor.phi);
          d.facing = Facing::either({yaw, 0.05}, {yaw + 1, 0.05}, other_weight);
        }
      test.update(frame, map, particlesAt(truth, random));
    }
    return test.logOdds();
  };
  EXPECT_GE(drive(0), SequentialPoseTest::kAcceptLogOdds);
  EXPECT_LT(drive(0.3), 1) << "the other attitude is a rival";
}

TEST(SequentialPoseTest, AVerifiedPoseIsConfirmedByOneLandmark)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {7, 3, 0}}});
  RandomStream random(5);
  SequentialPoseTest test(motionModelOf({}), map);
  test.accept();
  Pose2 truth{5, 2, 0};
  const auto update = [&](int k, int id, const Pose2& off)
  {
    truth = compose(truth, roundTripStep(k));
    Frame frame = simulatedFrame({.measures_range = true}, map, truth, roundTripStep(k), random);
    for (Reading& reading : frame.readings)
      std::erase_if(reading.detections, [&](const Detection& d) { return d.id != id; });
    test.update(frame, map, particlesAt(compose(truth, off), random));
    return test.logOdds();
  };
  double after = 0;
  for (int k = 0; k < 4; ++k) after = update(k, 2, {1, 1, 1});  // a false detection, say
  ASSERT_LT(after, SequentialPoseTest::kMaxLogOdds - 1);
  for (int k = 4; k < 30; ++k) after = update(k, 1, {});
  EXPECT_GT(after, SequentialPoseTest::kMaxLogOdds - 1);
}

TEST(SequentialPoseTest, AfterAGapOneDetectionConfirmsThePose)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}});
  RandomStream random(5);
  SequentialPoseTest test(motionModelOf({}), map);
  test.accept();
  Pose2 truth{5, 2, 0};
  const auto update = [&](int k, const Pose2& off)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame({.measures_range = true}, map, truth, roundTripStep(k), random);
    test.update(frame, map, particlesAt(compose(truth, off), random));
    return test.logOdds();
  };
  const auto endGap = [&]
  {
    test.endGap({.duration = 10});
    return test.logOdds();
  };
  EXPECT_NEAR(endGap(), -std::log(10 * SlipTest::kSlipRate), 0.01) << "it may have slipped";
  EXPECT_GE(update(0, {}), SequentialPoseTest::kAcceptLogOdds);
  const double before = endGap();
  double after = before;
  int k = 1;
  while (after == before && k < 30) after = update(k++, {1, 1, 1});  // the first detection away from the last one
  EXPECT_LT(after, before - 1);
  while (k < 60) after = update(k++, {});  // a pose that is corrected by the landmark fits it
  EXPECT_LT(after, SequentialPoseTest::kAcceptLogOdds);
}

TEST(SequentialPoseTest, ADoubtedPoseHasToBeVerifiedAgain)
{
  RandomStream random(1);
  SequentialPoseTest test({}, randomMap(5, 10, random));
  test.doubt();
  EXPECT_EQ(test.logOdds(), 0) << "there is nothing to take back";
  test.accept();
  test.doubt();
  EXPECT_EQ(test.logOdds(), SequentialPoseTest::kAcceptLogOdds / 2);
}

TEST(SequentialPoseTest, WhatWasRefutedStartsAnewOnceOthersCompete)
{
  RandomStream random(2);
  const LandmarkTable map = randomMap(15, 10, random);
  SequentialPoseTest test(motionModelOf({}), map);
  Pose2 truth{5, 2, 0};
  for (int k = 0; k < 30; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    test.update(simulatedFrame({}, map, truth, roundTripStep(k), random), map,
                particlesAt(compose(truth, {2, 3, 1}), random));
  }
  ASSERT_TRUE(test.refuted());
  test.doubt();
  EXPECT_EQ(test.logOdds(), 0);
}

TEST(SequentialPoseTest, LandmarksThatAreNeverSeenDoNotSpeakAgainstThePose)
{
  RandomStream random(6);
  const LandmarkTable map = randomMap(60, 10, random);
  const LandmarkTable shown({map[0], map[1], map[2], map[3], map[4]});  // the others are hidden
  SequentialPoseTest test(motionModelOf({}), map);
  Pose2 truth{5, 2, 0};
  std::vector<double> odds;
  for (int k = 0; k < 200; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame({.measures_range = true, .identified = false, .clutter = 0.05}, shown, truth,
                                       roundTripStep(k), random);
    test.update(frame, map, particlesAt(truth, random));
    odds.push_back(test.logOdds());
  }
  EXPECT_GE(*std::min_element(odds.begin(), odds.end()), SequentialPoseTest::kRejectLogOdds);
  EXPECT_GE(odds.back(), SequentialPoseTest::kAcceptLogOdds);
}

TEST(SequentialPoseTest, DetectionsThatSelectedTheModeDoNotCount)
{
  RandomStream random(1);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  const Frame frame = simulatedFrame({}, map, truth, {}, random);
  SequentialPoseTest test(motionModelOf({}), map);
  test.skip(frame);
  test.update(frame, map, particlesAt(truth, random));
  EXPECT_EQ(test.logOdds(), 0);
}

TEST(SequentialPoseTest, AFirstFrameWithManyDetectionsDoesNotVerifyAPose)
{
  RandomStream random(3);
  const LandmarkTable map = randomMap(15, 10, random);
  const Pose2 truth{5, 2, 0};
  const auto begun = [&](std::size_t detections)
  {
    const Frame frame = simulatedFrame({.measures_range = true, .detections = detections}, map, truth, {}, random);
    ParticleSet samples(Vector2d(5, 5));  // of a proposal that knows the pose: weights log(prior / density)
    const double std_xy = 0.05, std_phi = degToRad(1);
    for (int i = 0; i < 4000; ++i)
    {
      const Vector3d n(random.gaussian(), random.gaussian(), random.gaussian());
      const double log_density = -0.5 * n.squaredNorm() - 1.5 * std::log(kTwoPi) - std::log(std_xy * std_xy * std_phi);
      samples.add({truth.x + std_xy * n.x(), truth.y + std_xy * n.y(), truth.phi + std_phi * n.z()},
                  -std::log(kRegion.volume()) - log_density);
    }
    SequentialPoseTest test(motionModelOf({}), map);
    test.start(frame.readings, map, samples);
    return test.logOddsAgainstChance();
  };
  EXPECT_EQ(begun(8), SequentialPoseTest::kAcceptLogOdds / 2);
  EXPECT_LT(begun(1), begun(8));
}

TEST(SequentialPoseTest, EvidenceDecaysInAGapWithoutDetections)
{
  constexpr double kAfter = SequentialPoseTest::kDecayAfter, kMax = SequentialPoseTest::kMaxLogOdds;
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}});
  const auto after = [&](double gap, bool identified = false)
  {
    SequentialPoseTest test(motionModelOf({}), map);
    RandomStream random(3);
    const Frame seen = simulatedFrame({.identified = identified}, map, {5, 2, 0}, {}, random);
    test.skip(seen);
    test.accept();
    test.skip({.motion = {.duration = gap - 1}});
    EXPECT_EQ(test.logOdds(), kMax) << "no detection yet";
    test.skip(seen);  // a second later
    return test.logOdds();
  };
  EXPECT_EQ(after(kAfter), kMax);
  EXPECT_NEAR(after(kAfter + 10), kMax - 10 * SequentialPoseTest::kDecayPerS, 1e-9);
  EXPECT_LT(after(30), SequentialPoseTest::kAcceptLogOdds);
  EXPECT_EQ(after(600), 0) << "a gap refutes nothing";
  EXPECT_EQ(after(600, true), kMax) << "an identified landmark is not confused with another";
}

TEST(SequentialPoseTest, EvidenceAgainstAPoseDoesNotDecay)
{
  RandomStream random(5);
  const LandmarkTable map = randomMap(15, 10, random);
  SequentialPoseTest test(motionModelOf({}), map);
  const Pose2 truth{5, 2, 0};
  const Frame seen = simulatedFrame({.identified = true}, map, truth, {}, random);
  test.update(seen, map, particlesAt(compose(truth, {2, 3, 1}), random));
  const double against = test.logOdds();
  ASSERT_LT(against, -1);
  test.skip({.motion = {.duration = 600}});
  test.skip(simulatedFrame({.identified = false}, map, truth, {}, random));
  EXPECT_EQ(test.logOdds(), against);
}

TEST(SequentialPoseTest, AnIdentifiedDetectionInTheFramePreventsTheDecayAfterAGap)
{
  const LandmarkTable map({{.id = 1, .position = {2, 2, 0}}, {.id = 2, .position = {7, 3, 0}}});
  RandomStream random(3);
  const Pose2 truth{5, 2, 0};
  const Reading identified = simulatedFrame({}, map, truth, {}, random).readings.front();
  const Reading anonymous = simulatedFrame({.identified = false}, map, truth, {}, random).readings.front();
  const ParticleSet particles = particlesAt(truth, random);
  const auto after = [&](const std::vector<Reading>& seen)
  {
    SequentialPoseTest test(motionModelOf({}), map);
    test.accept();
    test.skip({.motion = {.duration = 600}});
    test.update({.readings = seen}, map, particles);
    return test.logOdds();
  };
  EXPECT_GT(after({identified, anonymous}), 12);
  EXPECT_GT(after({anonymous, identified}), 12);
  EXPECT_GT(after({identified}), 12);
  EXPECT_LT(after({anonymous}), SequentialPoseTest::kAcceptLogOdds) << "the evidence has decayed";
  EXPECT_GT(after({}), 13) << "no detection yet";
}

TEST(SequentialPoseTest, LimitsTheLogOdds)
{
  RandomStream random(1);
  SequentialPoseTest test({}, randomMap(5, 10, random));
  test.accept();
  EXPECT_TRUE(test.verified());
  EXPECT_EQ(test.logOdds(), SequentialPoseTest::kMaxLogOdds);
  test.reset();
  EXPECT_FALSE(test.verified());
  EXPECT_FALSE(test.refuted());
}
}  // namespace mrpt_ext::test_sequential_pose_test
