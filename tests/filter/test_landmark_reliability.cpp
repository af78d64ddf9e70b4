#include "mrpt_ext/filter/integrity/landmark_reliability.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_landmark_reliability
{
namespace
{
constexpr double kSensorClutter = 0.05;
const LandmarkTable kMap({{.id = 1, .position = {4, 0, 0}},
                          {.id = 2, .position = {0, 5, 0}},
                          {.id = 3, .position = {-3, -3, 0}}});
const Pose2 kRobot{0.5, 0.5, 0.2};

/// A posterior of 500 particles around the robot, 3 cm and 0.3 degrees wide.
ParticleSet posterior()
{
  ParticleSet particles;
  RandomStream random(1);
  for (int i = 0; i < 500; ++i)
    particles.add({kRobot.x + 0.03 * random.gaussian(), kRobot.y + 0.03 * random.gaussian(),
                   kRobot.phi + 0.005 * random.gaussian()},
                  -std::log(500));
  return particles;
}

/// Ranges to every landmark; of landmark 1 the stated share are outliers, of the others the sensor's clutter.
Reading ranges(RandomStream& random, double outliers_of_first, bool identified)
{
  Reading reading;
  reading.model = {.max_range = 20.0, .clutter_probability = kSensorClutter};
  for (std::size_t j = 0; j < kMap.size(); ++j)
  {
    const double truth = (kMap[j].position.head<2>() - kRobot.position()).norm();
    const bool outlier = random.chance(j == 0 ? outliers_of_first : kSensorClutter);
    const double range = outlier ? random.uniform(0, 20) : truth + 0.1 * random.gaussian();
    reading.detections.push_back({.id = identified ? kMap[j].id : kNoId, .range = range, .std_range = 0.1});
  }
  return reading;
}

LandmarkReliability learned(double outliers_of_first, bool identified, int frames, double prior_strength = 30)
{
  LandmarkReliability reliability(kMap.size(), prior_strength);
  const ParticleSet particles = posterior();
  RandomStream random(2);
  for (int k = 0; k < frames; ++k)
    reliability.observe(ranges(random, outliers_of_first, identified), kMap, particles, true);
  return reliability;
}
}  // namespace

TEST(LandmarkReliability, StartsAtTheSensorsClutter)
{
  const LandmarkReliability initial(3, 30);
  EXPECT_EQ(initial.clutter(0.05), LandmarkClutter(3, 0.05));
  EXPECT_EQ(initial.clutter(0.9), LandmarkClutter(3, 0.9));
}

TEST(LandmarkReliability, LearnsTheClutterOfAFaultyLandmark)
{
  const LandmarkClutter clutter = learned(0.4, true, 1000).clutter(kSensorClutter);
  EXPECT_NEAR(clutter[0], 0.4, 0.05);
  EXPECT_NEAR(clutter[1], kSensorClutter, 0.025);
  EXPECT_NEAR(clutter[2], kSensorClutter, 0.025);
}

TEST(LandmarkReliability, NeverTrustsALandmarkLessThanTheLimit)
{
  EXPECT_NEAR(learned(0.98, true, 1000).clutter(kSensorClutter)[0], 0.7, 1e-12);
}

TEST(LandmarkReliability, AnonymousDetectionsBelongToNoParticularLandmark)
{
  const LandmarkReliability reliability = learned(kSensorClutter, false, 1000);
  for (const double clutter : reliability.clutter(kSensorClutter)) EXPECT_NEAR(clutter, kSensorClutter, 1e-9);
  for (const LandmarkHistory& history : reliability.histories()) EXPECT_NEAR(history.seen, 950, 60);
}

TEST(LandmarkReliability, CountsAndResidualsAreReported)
{
  const LandmarkHistory history = learned(0.4, true, 1000).histories()[0];
  EXPECT_NEAR(history.seen, 1000, 1e-6);
  EXPECT_NEAR(history.associated / history.seen, 0.6, 0.05);
  EXPECT_NEAR(history.residual_sum / history.residual_weight, 0, 0.15);
  EXPECT_NEAR(std::sqrt(history.residual_sum2 / history.residual_weight), 1, 0.15);
}

TEST(LandmarkReliability, InlierRatioIsHighHereAndLowElsewhere)
{
  LandmarkReliability reliability(kMap.size(), 30);
  RandomStream random(3);
  const Reading reading = ranges(random, 0, true);
  ParticleSet elsewhere;
  elsewhere.add({-8, 9, 1}, 0);
  EXPECT_GT(reliability.observe(reading, kMap, posterior(), false), 0.9);
  EXPECT_LT(reliability.observe(reading, kMap, elsewhere, false), 0.05);
  for (const LandmarkHistory& history : reliability.histories()) EXPECT_EQ(history.seen, 0);  // observed, not learned
}

TEST(LandmarkReliability, NoDetectionsOrNoParticles)
{
  LandmarkReliability reliability(kMap.size(), 30);
  EXPECT_EQ(reliability.observe({}, kMap, posterior(), true), 0);
  RandomStream random(4);
  EXPECT_EQ(reliability.observe(ranges(random, 0, true), kMap, {}, true), 0);
  EXPECT_TRUE(LandmarkReliability(0, 30).clutter(0.1).empty());
}

TEST(LandmarkReliability, WithoutAPriorTheFirstDetectionsDecideAlone)
{
  EXPECT_EQ(LandmarkReliability(3, 0).clutter(0.05), LandmarkClutter(3, 0.05));
  for (const double clutter : learned(0.4, true, 5, 0).clutter(kSensorClutter))
    EXPECT_TRUE(clutter >= 0 && clutter <= 0.7);
}
}  // namespace mrpt_ext::test_landmark_reliability
