#include "mrpt_ext/filter/observation_model.h"

#include <gtest/gtest.h>

#include "mrpt_ext/likelihood/reading_likelihood.h"
#include "simulated_run.h"

namespace mrpt_ext::test_observation_model
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {1, 1, 0}},
                          {.id = 2, .position = {9, 2, 0}},
                          {.id = 3, .position = {5, 9, 0}}});
const Pose2 kTruth{4, 3, 0.5};

ObservationModel modelOf(bool learn = true) { return {kMap, {}, 5, learn, 1}; }

Frame frameOf(bool identified, RandomStream& random)
{
  return simulatedFrame({.measures_range = true, .identified = identified, .clutter = 0.1}, kMap, kTruth, {}, random);
}

ParticleSet particlesAt(const Pose2& pose, std::size_t count = 50)
{
  ParticleSet particles({5, 5});
  for (std::size_t i = 0; i < count; ++i) particles.add(pose, -std::log(static_cast<double>(count)));
  return particles;
}
}  // namespace

TEST(ObservationModel, WeightsWithTheLikelihoodOfAllReadingsAndTheCompass)
{
  RandomStream random(1);
  Frame frame = frameOf(true, random);
  frame.readings.push_back(frameOf(false, random).readings.front());
  const ObservationModel model = modelOf(false);
  ParticleSet particles({5, 5});
  for (int i = 0; i < 20; ++i)
    particles.add(compose(kTruth, {0.1 * random.gaussian(), 0.1 * random.gaussian(), 0.02 * random.gaussian()}), 0);
  model.weight(frame, particles);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    double expected = 0;
    for (const Reading& reading : frame.readings) expected += logLikelihood(reading, kMap, particles.pose(i));
    EXPECT_NEAR(particles.log_weight[i], expected, 0.02 + 1e-3 * std::abs(expected));
  }
  ParticleSet ahead = particlesAt(kTruth, 1), back = particlesAt({kTruth.x, kTruth.y, wrap(kTruth.phi + kPi)}, 1);
  const Frame compass{.compass = CompassRecord{.heading = kTruth.phi, .std_heading = 0.1}};
  model.weight(compass, ahead);
  model.weight(compass, back);
  EXPECT_GT(ahead.log_weight[0], back.log_weight[0] + 3);
}

TEST(ObservationModel, ModesThatCompeteAreNotWeightedWithCorrelatedAnonymousBearings)
{
  Reading reading;
  reading.detections = {{.bearing = 0.4, .std_bearing = 0.01}, {.id = 2, .bearing = 1.0, .std_bearing = 0.01}};
  const Frame frame{.readings = {reading}};
  ObservationModel model = modelOf();
  EXPECT_EQ(model.select(frame, true).readings.front().detections.size(), 2U);
  EXPECT_EQ(model.select(frame, true).readings.front().detections.size(), 1U);
  EXPECT_EQ(model.select(frame, false).readings.front().detections.size(), 2U);
  model.move({.increment = {1, 0, 0}, .path_length = 1, .duration = 1});
  EXPECT_EQ(model.select(frame, true).readings.front().detections.size(), 2U);
  model.restart();
  EXPECT_EQ(model.select(frame, true).readings.front().detections.size(), 2U);
}

TEST(ObservationModel, ExpectsInliersBySensorClutterAndByLearnedClutter)
{
  RandomStream random(2);
  ObservationModel model = modelOf();
  Frame frame = frameOf(true, random);
  frame.readings.front().detections.push_back({.id = 77, .bearing = 0.1, .std_bearing = 0.01});  // not in the map
  const InlierReport here = model.countInliers(frame, particlesAt(kTruth), false);
  ASSERT_EQ(here.size(), 1U);
  EXPECT_EQ(here[0].sensor, " ranges and bearings");
  EXPECT_EQ(here[0].detections, 3U);
  EXPECT_GT(here[0].inliers, 2.7);
  EXPECT_NEAR(here[0].expected_by_sensor, 2.7, 1e-9);
  EXPECT_NEAR(here[0].expected, 2.7, 1e-9);
  EXPECT_LT(model.countInliers(frame, particlesAt({8, 8, 3}), false)[0].inliers, 0.3);
}

TEST(ObservationModel, LearnsFaultyLandmarksOnlyIfSwitchedOn)
{
  RandomStream random(3);
  const auto clutter_after = [&](bool model_learns, bool learn)
  {
    ObservationModel model = modelOf(model_learns);
    for (int k = 0; k < 100; ++k)
    {
      Frame frame = frameOf(true, random);
      for (Detection& detection : frame.readings.front().detections)
        if (detection.id == 3) detection.range = random.uniform(0, 20);
      (void)model.countInliers(frame, particlesAt(kTruth), learn);
    }
    return model.reliability().clutter(0.1)[2];
  };
  EXPECT_GT(clutter_after(true, true), 0.5);
  EXPECT_EQ(clutter_after(true, false), 0.1);
  EXPECT_EQ(clutter_after(false, true), 0.1);
}
}  // namespace mrpt_ext::test_observation_model
