#include "mrpt_ext/filter/initializer.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/bounded_frame.h"
#include "mrpt_ext/likelihood/scoring_work.h"
#include "simulated_run.h"

namespace mrpt_ext::test_initializer
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {2, 2, 0}},
                          {.id = 2, .position = {8, 8, 0}}});  // half a turn: the same
const Pose2 kTruth{5, 2, 0}, kTwin{5, 8, kPi};

PoseHypothesis hypothesisAt(const Pose2& pose)
{
  return {.pose = {pose, Vector3d(0.01, 0.01, 0.002).asDiagonal()}, .weight = 0.5};
}

struct Scene
{
  ParticleFilterOptions options{.particles = 500, .initial_particles = 3000, .region = {{0, 0}, {10, 10}}};
  ObservationModel model{kMap, {}, 30, true, 1};
  RandomStream random{1};

  Initialization initialize(const Frame& frame, const std::function<Proposal()>& closed_forms)
  {
    return Initializer(options, model, random).initialize(frame, closed_forms, ParticleSet({5, 5}));
  }
  Frame frame(bool identified)
  {
    return simulatedFrame({.measures_range = true, .identified = identified}, kMap, kTruth, {}, random);
  }
};

double weightNear(ParticleSet particles, const Pose2& pose)
{
  normalizeWeights(particles);
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (distance(particles.pose(i), pose) < 0.5) sum += std::exp(double{particles.log_weight[i]});
  return sum;
}
}  // namespace

TEST(Initializer, AKnownPoseGivesItsGaussianAndIsAlwaysAccepted)
{
  Scene scene;
  scene.options.initial_mode = InitialMode::gaussian;
  scene.options.initial_pose = {kTruth, Vector3d(0.04, 0.01, 0).asDiagonal()};
  const Initialization start = scene.initialize({}, [] { return Proposal({hypothesisAt(kTwin)}); });
  EXPECT_TRUE(start.accepted);
  ASSERT_EQ(start.particles.size(), 500U);
  double sum2 = 0;
  for (std::size_t i = 0; i < 500; ++i)
  {
    sum2 += square(start.particles.pose(i).x - kTruth.x) / 500;
    EXPECT_NEAR(start.particles.pose(i).phi, 0, 1e-6);
  }
  EXPECT_NEAR(std::sqrt(sum2), 0.2, 0.03);
}

TEST(Initializer, AUniformStartIgnoresHypotheses)
{
  Scene scene;
  scene.options.initial_mode = InitialMode::uniform;
  bool asked = false;
  const Initialization start = scene.initialize({},
                                                [&]
                                                {
                                                  asked = true;
                                                  return Proposal({hypothesisAt(kTwin)});
                                                });
  EXPECT_TRUE(start.accepted);
  EXPECT_FALSE(asked);
  EXPECT_EQ(start.particles.size(), 3000U);
  EXPECT_NEAR(weightNear(start.particles, kTwin), kPi * 0.25 / 100, 0.006);
}

TEST(Initializer, HypothesesAreWeightedByTheirLikelihoodNotByTheirOwnWeight)
{
  Scene scene;
  const Frame frame = scene.frame(false);
  const auto propose = []
  {
    HypothesisSet both{hypothesisAt(kTruth), hypothesisAt(kTwin)};
    both[1].weight = 0.05;
    return Proposal(both);
  };
  const Initialization start = scene.initialize(frame, propose);
  EXPECT_TRUE(start.accepted);
  EXPECT_NEAR(weightNear(start.particles, kTruth), 0.5, 0.15);
  EXPECT_NEAR(weightNear(start.particles, kTwin), 0.5, 0.15);
}

TEST(Initializer, DoesNotAcceptAnAmbiguousStartBeforeTheWindowIsFull)
{
  const auto accepted = [](bool identified, bool complete, const HypothesisSet& hypotheses)
  {
    Scene scene;
    Proposal proposal(hypotheses);
    proposal.complete = complete;
    return scene.initialize(scene.frame(identified), [&] { return proposal; }).accepted;
  };
  const HypothesisSet both{hypothesisAt(kTruth), hypothesisAt(kTwin)};
  EXPECT_FALSE(accepted(false, false, both));
  EXPECT_TRUE(accepted(false, true, both));
  EXPECT_TRUE(accepted(true, false, both));
  EXPECT_FALSE(accepted(true, false, {}));
  EXPECT_TRUE(accepted(true, true, {}));
}

TEST(Initializer, WeightsWithTheReadingsOfTheWindow)
{
  Scene scene;
  const Frame seen = scene.frame(true);
  const auto propose = [&]
  {
    Proposal proposal({hypothesisAt(kTruth), hypothesisAt(kTwin)});
    proposal.window_readings = seen.readings;
    return proposal;
  };
  const Initialization start = scene.initialize({}, propose);
  EXPECT_EQ(start.measurements.readings.size(), 1U);
  EXPECT_GT(weightNear(start.particles, kTruth), 0.99);
  EXPECT_EQ(start.samples.size(), start.particles.size());
  EXPECT_NE(start.samples.log_weight, start.particles.log_weight);
}

TEST(Initializer, WhatTakesTooLongIsScoredWithFewerSamplesThenWithFewerDetections)
{
  std::vector<Landmark> landmarks(10'000);
  RandomStream random(4);
  for (Landmark& landmark : landmarks) landmark.position = {random.uniform(0, 300), random.uniform(0, 300), 0};
  const LandmarkTable map(std::move(landmarks));
  const ParticleFilterOptions options{.particles = 500, .initial_particles = 3000, .region = {{0, 0}, {300, 300}}};
  ObservationModel model(map, {}, 30, true, 1);
  Reading reading{.sensor = "camera"};
  for (int d = 0; d < 100; ++d) reading.detections.push_back({.bearing = wrap(0.06 * d), .std_bearing = 0.01});
  const Initialization start =
      Initializer(options, model, random).initialize({.readings = {reading}}, {}, ParticleSet({150, 150}));
  EXPECT_GE(start.samples.size(), 500U);
  EXPECT_LT(start.samples.size(), 2000U);
  EXPECT_GE(detectionCount(start.measurements), 5U);
  EXPECT_LT(detectionCount(start.measurements), 100U);
  EXPECT_LT(start.densities, 4 * kMostDensities) << "of all draws";
}

TEST(Initializer, OfManyHypothesesAtOnePlaceFewerSamplesAreDrawn)
{
  Scene scene;
  scene.options.initial_particles = 20'000;
  const HypothesisSet many(900, hypothesisAt(kTruth));
  Proposal proposal(many);
  proposal.complete = true;
  // What no pose explains takes many draws.
  const Initialization start = scene.initialize(
      {.readings = {Reading{.detections = {{.range = 500.0, .std_range = 0.001}}}}}, [&] { return proposal; });
  EXPECT_TRUE(start.accepted);
  EXPECT_GE(start.samples.size(), 500U);
  EXPECT_LT(start.densities, 4 * kMostDensities);
}

TEST(AnnealingExponent, KeepsTheEffectiveSamples)
{
  RandomStream random(5);
  std::vector<float> prior(5000), weight(5000);
  for (std::size_t i = 0; i < prior.size(); ++i)
  {
    prior[i] = static_cast<float>(random.gaussian() * 0.1);
    const double x = random.uniform(-1, 1);
    weight[i] = prior[i] + static_cast<float>(-0.5 * square(x / 1e-3));  // a likelihood that few samples have
  }
  const double exponent = annealingExponent(prior, weight, 200);
  ASSERT_LT(exponent, 1);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < prior.size(); ++i)
  {
    const double w = std::exp(double{prior[i]} + exponent * double{weight[i] - prior[i]});
    sum += w;
    squares += w * w;
  }
  EXPECT_NEAR(sum * sum / squares, 200, 5);
  EXPECT_EQ(annealingExponent(prior, prior, 200), 1);
}
}  // namespace mrpt_ext::test_initializer
