#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_filter_recovery
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {1, 1, 0}},
                          {.id = 2, .position = {9, 2, 0}},
                          {.id = 3, .position = {5, 9, 0}},
                          {.id = 4, .position = {2, 7, 0}},
                          {.id = 5, .position = {8, 8, 0}},
                          {.id = 6, .position = {4, 4, 0}}});

SimulatedRobot rangeBearingRobot()
{
  SimulatedRobot robot;
  robot.measures_range = true;
  robot.clutter = 0.02;
  robot.detections = 3;
  return robot;
}

ParticleFilterOptions recoveryOptions(const SimulatedRobot& robot)
{
  ParticleFilterOptions options;
  options.region = {{0, 0}, {10, 10}};
  options.motion = motionModelOf(robot);
  return options;
}

/// What a solver would propose: an inexact pose, and two wrong ones.
HypothesisSet proposalsAround(const Pose2& truth)
{
  const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
  return {{.pose = {{2, 2, 0}, covariance}, .weight = 0.5},
          {.pose = {{truth.x + 0.1, truth.y - 0.1, truth.phi + 0.03}, covariance}, .weight = 0.3},
          {.pose = {{8, 5, 2}, covariance}, .weight = 0.2}};
}
}  // namespace

TEST(FilterRecovery, DetectsAKidnappingAndRecovers)
{
  const SimulatedRobot robot = rangeBearingRobot();
  for (std::uint64_t run = 0; run < 5; ++run)
  {
    RandomStream random(31, run);
    ParticleFilter filter(recoveryOptions(robot), kMap, 7, run);
    Pose2 truth{3, 3, 0};
    int wrong_and_ok = 0, not_ok = 0, found_after = -1;
    bool reseeded = false;
    for (int k = 0; k < 120; ++k)
    {
      truth = k == 60 ? Pose2{7, 6, -2} : compose(truth, roundTripStep(k));
      const Frame frame = simulatedFrame(robot, kMap, truth, roundTripStep(k), random);
      const FilterStep step = filter.process(frame, {[&] { return proposalsAround(truth); }});
      const bool right = distance(step.modes.modes.front().pose.mean, truth) < 0.3;
      if (k > 5 && k < 60)
      {
        EXPECT_TRUE(right && step.verdict == Verdict::ok && !step.reseeded) << run << " " << k;
      }
      if (k < 60) continue;
      reseeded = reseeded || step.reseeded || step.verifying;
      wrong_and_ok += !right && step.verdict == Verdict::ok ? 1 : 0;
      not_ok += step.verdict != Verdict::ok ? 1 : 0;
      if (found_after < 0 && right) found_after = k - 60;
      if (k > 80)
      {
        EXPECT_TRUE(right && step.verdict == Verdict::ok) << run << " " << k << " " << step.reason;
      }
    }
    EXPECT_TRUE(reseeded);
    EXPECT_GE(not_ok, 1) << run;
    EXPECT_LE(wrong_and_ok, 2) << run;  // until the inlier ratio has fallen
    EXPECT_GE(found_after, 1) << run;
    EXPECT_LE(found_after, 6) << run;
  }
}

TEST(FilterRecovery, WithoutProposalsTheUniformShareFindsTheRobotToo)
{
  SimulatedRobot robot = rangeBearingRobot();
  robot.std_range = 0.3;
  robot.std_bearing = degToRad(5);
  RandomStream random(32);
  ParticleFilter filter(recoveryOptions(robot), kMap, 7, 0);
  Pose2 truth{3, 3, 0};
  FilterStep step;
  for (int k = 0; k < 200; ++k)
  {
    truth = k == 60 ? Pose2{7, 6, -2} : compose(truth, roundTripStep(k));
    step = filter.process(simulatedFrame(robot, kMap, truth, roundTripStep(k), random), {});
  }
  EXPECT_EQ(step.verdict, Verdict::ok) << step.reason;
  EXPECT_LT(distance(step.modes.modes.front().pose.mean, truth), 0.5);
}

TEST(FilterRecovery, AdaptiveSizeShrinksWhenConvergedAndGrowsWhenLost)
{
  SimulatedRobot robot = rangeBearingRobot();
  robot.detections = 1;
  ParticleFilterOptions options = recoveryOptions(robot);
  options.adaptive_size = true;
  options.kld.max_size = 20000;
  RandomStream random(33);
  ParticleFilter filter(options, kMap, 7, 0);
  Pose2 truth{3, 3, 0};
  std::size_t converged = 0, largest_when_lost = 0;
  for (int k = 0; k < 120; ++k)
  {
    truth = k == 60 ? Pose2{7, 6, -2} : compose(truth, roundTripStep(k));
    const FilterStep step = filter.process(simulatedFrame(robot, kMap, truth, roundTripStep(k), random), {});
    EXPECT_LE(step.particles, 20000u + options.particles);
    if (k == 59) converged = step.particles;
    if (k >= 60) largest_when_lost = std::max(largest_when_lost, step.particles);
  }
  EXPECT_LT(converged, 4000u);
  EXPECT_GT(largest_when_lost, 2 * converged);
}

TEST(FilterRecovery, DetectionsOfLandmarksThatAreNotInTheMapDoNotMeanLost)
{
  const SimulatedRobot robot = rangeBearingRobot();
  RandomStream random(34);
  ParticleFilter filter(recoveryOptions(robot), kMap, 7, 0);
  Pose2 truth{3, 3, 0};
  for (int k = 0; k < 60; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    Frame frame = simulatedFrame(robot, kMap, truth, roundTripStep(k), random);
    for (int other = 0; other < 12; ++other)  // other robots, say
      frame.readings[0].detections.push_back(
          {.id = 100 + other, .bearing = random.uniform(-kPi, kPi), .std_bearing = 0.1});
    const FilterStep step = filter.process(frame, {[&] { return proposalsAround(truth); }});
    if (k > 5)
    {
      EXPECT_EQ(step.verdict, Verdict::ok) << k << " " << step.reason;
    }
  }
}
}  // namespace mrpt_ext::test_filter_recovery
