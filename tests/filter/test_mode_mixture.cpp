#include "mrpt_ext/filter/mode_mixture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulated_run.h"

namespace mrpt_ext::test_mode_mixture
{
namespace
{
// The same after half a turn about (5, 5).
const LandmarkTable kMirrored({{.position = {1, 2, 0}},
                               {.position = {9, 8, 0}},
                               {.position = {3, 6, 0}},
                               {.position = {7, 4, 0}},
                               {.position = {2, 9, 0}},
                               {.position = {8, 1, 0}}});

Pose2 mirrored(const Pose2& pose) { return {10 - pose.x, 10 - pose.y, wrap(pose.phi + kPi)}; }

SimulatedRobot anonymousRobot()
{
  SimulatedRobot robot;
  robot.identified = false;
  robot.measures_range = true;
  robot.detections = 4;
  robot.clutter = 0.01;
  return robot;
}

HypothesisSet bothPoses(const Pose2& truth)
{
  const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
  return {{.pose = {truth, covariance}, .weight = 0.5}, {.pose = {mirrored(truth), covariance}, .weight = 0.5}};
}

double weightNear(const ModeSet& modes, const Pose2& pose)
{
  double sum = 0;
  for (const Mode& mode : modes.modes)
    if (distance(mode.pose.mean, pose) < 0.5 && std::abs(wrap(mode.pose.mean.phi - pose.phi)) < 1) sum += mode.weight;
  return sum;
}

/// How far the weight of the true mode drifts after the first steps.
double drift(std::uint64_t run, bool mixture)
{
  const SimulatedRobot robot = anonymousRobot();
  ParticleFilterOptions options;
  options.region = {{0, 0}, {10, 10}};
  options.motion = motionModelOf(robot);
  options.particles = options.initial_particles = 1000;
  options.mode_kalman_filters = mixture;
  RandomStream random(41, run);
  ParticleFilter filter(options, kMirrored, 9, run);
  Pose2 truth{3, 3, 0};
  double first = 0, furthest = 0;
  for (int k = 0; k < 150; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame(robot, kMirrored, truth, roundTripStep(k), random);
    const FilterStep step = filter.process(frame, {[&] { return bothPoses(truth); }});
    const double weight = weightNear(step.modes, truth);
    if (k == 10) first = weight;
    if (k > 10) furthest = std::max(furthest, std::abs(weight - first));
    if (k > 10 && mixture)
    {
      EXPECT_EQ(step.verdict, Verdict::ambiguous) << run << " " << k << " " << step.reason;
    }
  }
  return furthest;
}
}  // namespace

TEST(ModeMixture, EqualModesKeepTheirWeights)
{
  double with = 0, without = 0;
  for (std::uint64_t run = 0; run < 6; ++run)
  {
    const double one = drift(run, true);
    EXPECT_LT(one, 0.1) << run;
    with += one / 6;
    without += drift(run, false) / 6;
  }
  EXPECT_LT(3 * with, without);
}

TEST(ModeMixture, WeightsAreCorrectedOnlyByMoreThanChance)
{
  MixtureComponent component;
  for (int k = 0; k < 50; ++k) EXPECT_EQ(component.correctWeight(k % 2 == 0 ? 0.1 : -0.1, 0.01), 0);
  double corrected = 0;
  for (int k = 0; k < 100; ++k) corrected += component.correctWeight(0.2, 1e-4);
  EXPECT_GT(corrected, 15);
  EXPECT_LE(corrected, 20.1);
}

TEST(ModeMixture, AModeThatLostItsParticlesGetsThemBackWhenItIsLikelyAgain)
{
  const SimulatedRobot robot = anonymousRobot();
  LandmarkTable map(
      {{.id = 1, .position = {1, 2, 0}}, {.id = 2, .position = {9, 8, 0}}, {.id = 3, .position = {3, 6, 0}}});
  const Pose2 truth{3, 3, 0}, wrong{7, 6, 1};
  RandomStream random(42);
  const auto cloud = [&](const Pose2& pose, ParticleSet& particles, double weight)
  {
    for (int i = 0; i < 200; ++i)
      particles.add(
          {pose.x + 0.05 * random.gaussian(), pose.y + 0.05 * random.gaussian(), pose.phi + 0.02 * random.gaussian()},
          std::log(weight / 200));
  };
  ModeMixture mixture(motionModelOf(robot), {});
  ParticleSet both({5, 5}), only_wrong({5, 5});
  cloud(truth, both, 0.5);
  cloud(wrong, both, 0.5);
  cloud(wrong, only_wrong, 1);
  mixture.associate(findModes(both, {}), both);
  ASSERT_EQ(mixture.components().size(), 2U);
  mixture.associate(findModes(only_wrong, {}), only_wrong);

  SimulatedRobot identified = robot;
  identified.identified = true;
  identified.detections = 3;
  bool respawned = false;
  for (int k = 0; k < 5 && !respawned; ++k)
  {
    Frame frame = simulatedFrame(identified, map, truth, {}, random);
    frame.motion = {};
    mixture.predictAndUpdate(only_wrong, frame, map);
    for (const Reading& reading : frame.readings)
      for (std::size_t i = 0; i < only_wrong.size(); ++i)
        only_wrong.log_weight[i] += static_cast<float>(logLikelihood(reading, map, only_wrong.pose(i)));
    mixture.reweight(only_wrong);
    normalizeWeights(only_wrong);
    respawned = mixture.respawn(only_wrong, 100, random);
  }
  ASSERT_TRUE(respawned);
  normalizeWeights(only_wrong);
  EXPECT_GT(weightNear(findModes(only_wrong, {}), truth), 0.5);
}

TEST(ModeMixture, ModesAreCountedOnlyWhenAllWeightIsInCompactOnes)
{
  const Matrix3d narrow = 1e-3 * Matrix3d::Identity(), wide = 4 * Matrix3d::Identity();
  EXPECT_EQ(countCompactModes({{{{{}, narrow}, 0.6}, {{{}, narrow}, 0.395}, {{{}, wide}, 0.005}}, {}}), 2U);
  EXPECT_EQ(countCompactModes({{{{{}, narrow}, 0.6}, {{{}, wide}, 0.4}}, {}}), 0U);
  EXPECT_EQ(countCompactModes({}), 0U);
}
}  // namespace mrpt_ext::test_mode_mixture
