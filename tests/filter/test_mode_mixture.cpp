#include "mrpt_ext/filter/mode_mixture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulated_run.h"

namespace mrpt_ext
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

SimulatedRobot namelessRobot()
{
  SimulatedRobot robot;
  robot.named = false;
  robot.measures_range = true;
  robot.detections = 4;
  robot.clutter = 0.01;
  return robot;
}

HypothesisSet bothPlaces(const Pose2& truth)
{
  const Matrix3d covariance = Vector3d(0.01, 0.01, 0.002).asDiagonal();
  return {{.pose = {truth, covariance}, .weight = 0.5}, {.pose = {mirrored(truth), covariance}, .weight = 0.5}};
}

double weightNear(const ModeSet& modes, const Pose2& place)
{
  double sum = 0;
  for (const Mode& mode : modes.modes)
    if (distance(mode.pose.mean, place) < 0.5 && std::abs(wrap(mode.pose.mean.phi - place.phi)) < 1) sum += mode.weight;
  return sum;
}

/// How far the weight of the true place goes from where it was after the first steps.
double drift(std::uint64_t run, bool companions)
{
  const SimulatedRobot robot = namelessRobot();
  ParticleFilterOptions options;
  options.region = {{0, 0}, {10, 10}};
  options.motion = motionModelOf(robot);
  options.particles = options.initial_particles = 1000;
  options.companions = companions;
  RandomStream random(41, run);
  ParticleFilter filter(options, kMirrored, 9, run);
  Pose2 truth{3, 3, 0};
  double first = 0, furthest = 0;
  for (int k = 0; k < 150; ++k)
  {
    truth = compose(truth, roundTripStep(k));
    const Frame frame = simulatedFrame(robot, kMirrored, truth, roundTripStep(k), random);
    const FilterStep step = filter.process(frame, [&] { return bothPlaces(truth); });
    const double weight = weightNear(step.modes, truth);
    if (k == 10) first = weight;
    if (k > 10) furthest = std::max(furthest, std::abs(weight - first));
    if (k > 10 && companions)
    {
      EXPECT_EQ(step.verdict, Verdict::ambiguous) << run << " " << k << " " << step.reason;
    }
  }
  return furthest;
}
}  // namespace

TEST(ModeMixture, EqualPlacesKeepTheirWeights)
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

TEST(ModeMixture, DifferencesAreDueOnlyWhenTheyAreMoreThanChance)
{
  MixtureComponent companion;
  for (int k = 0; k < 50; ++k) EXPECT_EQ(companion.settle(k % 2 == 0 ? 0.1 : -0.1, 0.01), 0);
  double paid = 0;
  for (int k = 0; k < 100; ++k) paid += companion.settle(0.2, 1e-4);
  EXPECT_GT(paid, 15);
  EXPECT_LE(paid, 20.1);
}

TEST(ModeMixture, APlaceThatLostItsParticlesGetsThemBackWhenEvidenceSpeaksForIt)
{
  const SimulatedRobot robot = namelessRobot();
  LandmarkTable map(
      {{.id = 1, .position = {1, 2, 0}}, {.id = 2, .position = {9, 8, 0}}, {.id = 3, .position = {3, 6, 0}}});
  const Pose2 truth{3, 3, 0}, wrong{7, 6, 1};
  RandomStream random(42);
  const auto cloud = [&](const Pose2& place, ParticleSet& particles, double weight)
  {
    for (int i = 0; i < 200; ++i)
      particles.add({place.x + 0.05 * random.gaussian(), place.y + 0.05 * random.gaussian(),
                     place.phi + 0.02 * random.gaussian()},
                    std::log(weight / 200));
  };
  ModeMixture companions(motionModelOf(robot), {});
  ParticleSet both({5, 5}), only_wrong({5, 5});
  cloud(truth, both, 0.5);
  cloud(wrong, both, 0.5);
  cloud(wrong, only_wrong, 1);
  companions.follow(findModes(both, {}), both);
  ASSERT_EQ(companions.all().size(), 2U);
  companions.follow(findModes(only_wrong, {}), only_wrong);

  SimulatedRobot named = robot;
  named.named = true;
  named.detections = 3;
  bool revived = false;
  for (int k = 0; k < 5 && !revived; ++k)
  {
    Frame frame = simulatedFrame(named, map, truth, {}, random);
    frame.motion = {};
    companions.predictAndUpdate(only_wrong, frame, map);
    for (const Reading& reading : frame.readings)
      for (std::size_t i = 0; i < only_wrong.size(); ++i)
        only_wrong.log_weight[i] += static_cast<float>(logLikelihood(reading, map, only_wrong.pose(i)));
    companions.reweight(only_wrong);
    normalizeWeights(only_wrong);
    revived = companions.revive(only_wrong, 100, random);
  }
  ASSERT_TRUE(revived);
  normalizeWeights(only_wrong);
  EXPECT_GT(weightNear(findModes(only_wrong, {}), truth), 0.5);
}

TEST(ModeMixture, PlacesAreCountedOnlyWhenAllWeightIsInCompactModes)
{
  const Matrix3d narrow = 1e-3 * Matrix3d::Identity(), wide = 4 * Matrix3d::Identity();
  EXPECT_EQ(countPlaces({{{{{}, narrow}, 0.6}, {{{}, narrow}, 0.395}, {{{}, wide}, 0.005}}, {}}), 2U);
  EXPECT_EQ(countPlaces({{{{{}, narrow}, 0.6}, {{{}, wide}, 0.4}}, {}}), 0U);
  EXPECT_EQ(countPlaces({}), 0U);
}
}  // namespace mrpt_ext
