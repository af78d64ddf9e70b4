#include "mrpt_ext/filter/bias_filter.h"

#include <gtest/gtest.h>

#include "simulated_run.h"
#include "test_length.h"

namespace mrpt_ext::test_bias_filter
{
namespace
{
const BiasModel kOffset{{.kind = BiasKind::range_offset, .std = 0.1}};
const LandmarkTable kMap({{.id = 1, .position = {5, 0, 0}}, {.id = 2, .position = {0, 5, 0}}});

/// Moments of a mode at this pose, without any knowledge of the offset.
KalmanState modeAt(const Pose2& pose)
{
  return startingState({pose, Vector3d(1e-2, 1e-2, 1e-4).asDiagonal()}, kOffset);
}

Frame rangeTo(int landmark, double range)
{
  Reading reading;
  reading.model = {.max_range = 20.0, .clutter_probability = 0.01};
  reading.detections = {{.id = landmark, .range = range, .std_range = 1e-3}};
  Frame frame;
  frame.readings = {reading};
  return frame;
}

ParticleSet particlesAt(const Pose2& pose, std::size_t count)
{
  ParticleSet particles({0, 0}, kOffset);
  for (std::size_t i = 0; i < count; ++i) particles.add(pose, 0);
  return particles;
}

/// The range offset after a drive, and the true one.
struct Learned
{
  double truth = 0;
  BiasEstimate estimate;
};

Learned learn(std::uint64_t run, int steps)
{
  const SimulatedRobot robot{.measures_range = true};
  RandomStream random(29, run);
  const LandmarkTable map = randomMap(10, 10, random);
  Learned learned{.truth = kOffset[0].std * random.gaussian()};
  ParticleFilterOptions options;
  options.particles = options.initial_particles = 200;
  options.region = {{0, 0}, {12, 12}};
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {{8, 5, kPi / 2}, Vector3d(0.01, 0.01, 0.001).asDiagonal()};
  options.motion = motionModelOf(robot);
  options.biases = kOffset;
  ParticleFilter filter(options, map, 5, run);
  Pose2 truth = options.initial_pose.mean;
  for (int k = 0; k < steps; ++k)
  {
    const Pose2 increment = k > 0 ? roundTripStep(k) : Pose2{};
    truth = compose(truth, increment);
    Frame frame = simulatedFrame(robot, map, truth, increment, random);
    for (Detection& detection : frame.readings[0].detections) *detection.range += learned.truth;
    learned.estimate = filter.process(frame, {noProposals}).biases[0];
  }
  return learned;
}
}  // namespace

TEST(BiasFilter, DrawsFromTheConditionalDensityGivenThePose)
{
  BiasFilter filter({}, kOffset);
  filter.follow(modeAt({0, 0, 0}), {}, kMap);
  filter.follow(modeAt({0, 0, 0}), rangeTo(1, 5.05), kMap);  // tells the sum of distance and offset only
  RandomStream random(1);
  for (const double x : {-0.1, 0.0, 0.1})
  {
    ParticleSet particles = particlesAt({x, 0, 0}, 100);
    filter.draw(particles, random);
    for (const float offset : particles.bias[0]) EXPECT_NEAR(offset, 5.05 - (5 - x), 5e-3);
  }
}

TEST(BiasFilter, LeavesParticlesElsewhereAlone)
{
  BiasFilter filter({}, kOffset);
  ParticleSet particles = particlesAt({9, 9, 2}, 10);
  RandomStream random(1);
  filter.draw(particles, random);  // it follows no mode
  filter.follow(modeAt({0, 0, 0}), {}, kMap);
  filter.draw(particles, random);
  EXPECT_EQ(particles.bias[0], std::vector<float>(10, 0.0F));
}

TEST(BiasFilter, KeepsWhatItLearnedWhileThereAreSeveralModes)
{
  BiasFilter filter({}, kOffset);
  EXPECT_FALSE(filter.estimates());
  const KalmanState mode = startingState({{0, 0, 0}, 1e-6 * Matrix3d::Identity()}, kOffset);
  filter.follow(mode, {}, kMap);
  filter.follow(mode, rangeTo(1, 5.05), kMap);
  filter.follow(std::nullopt, {}, kMap);
  EXPECT_FALSE(filter.estimates());
  filter.follow(modeAt({2, 2, 1}), {}, kMap);
  EXPECT_NEAR(filter.estimates()->at(0).mean, 0.05, 2e-3);
  EXPECT_LT(filter.estimates()->at(0).std, 2e-3);
}

TEST(BiasFilter, ForgetsWhatItLearnedAtAnotherPlace)
{
  BiasFilter filter({}, kOffset);
  const KalmanState mode = startingState({{0, 0, 0}, 1e-6 * Matrix3d::Identity()}, kOffset);
  filter.follow(mode, {}, kMap);
  filter.follow(mode, rangeTo(1, 5.05), kMap);
  filter.follow(modeAt({2, 2, 1}), {}, kMap);  // the particles have left it
  EXPECT_DOUBLE_EQ(filter.estimates()->at(0).mean, 0);
  EXPECT_DOUBLE_EQ(filter.estimates()->at(0).std, 0.1);
}

// Particles alone would agree on a wrong value: the deviation that they state falls to a fraction of the error.
TEST(BiasFilter, TheStatedDeviationOfAConstantErrorAgreesWithTruth)
{
  double squared = 0;
  const int runs = testing::runsOfTest(20);
  for (int run = 0; run < runs; ++run)
  {
    const Learned learned = learn(static_cast<std::uint64_t>(run), 400);
    squared += square((learned.estimate.mean - learned.truth) / learned.estimate.std);
    EXPECT_LT(learned.estimate.std, 0.01) << "nothing was learned in run " << run;
  }
  const double scatter = std::sqrt(squared / runs);  // in stated deviations
  if (testing::isShort()) return;                    // too few for the bounds
  EXPECT_GT(scatter, 0.67);
  EXPECT_LT(scatter, 1.5);
}
}  // namespace mrpt_ext::test_bias_filter
