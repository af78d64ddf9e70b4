#include "mrpt_ext/filter/integrity/missed_landmarks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/filter/integrity/sequential_pose_test.h"
#include "simulated_run.h"

namespace mrpt_ext::test_missed_landmarks
{
namespace
{
constexpr double kDetection = 0.8;

/// Three landmarks in view of a robot at the origin, and one far beyond the range of its sensor.
LandmarkTable fourLandmarks()
{
  return LandmarkTable(
      {{.position = {3, 0, 0}}, {.position = {0, 4, 0}}, {.position = {-4, 0, 0}}, {.position = {0, -20, 0}}});
}

ParticleSet robotAtOrigin()
{
  ParticleSet robot(Vector2d(0, 0));
  robot.add({0, 0, 0}, 0);
  return robot;
}

/// Anonymous detections at these bearings, 4 m away.
Reading detectionsAt(const std::vector<double>& bearings, double detection_probability = kDetection)
{
  Reading reading;
  reading.model.max_range = 10;
  reading.model.has_field_of_view = true;
  reading.model.detection_probability = detection_probability;
  for (const double bearing : bearings)
    reading.detections.push_back({.bearing = bearing, .range = 4.0, .std_bearing = 0.02, .std_range = 0.1});
  return reading;
}

double count(MissedLandmarks& missed, const Reading& reading)
{
  return missed.count(reading, fourLandmarks(), robotAtOrigin());
}
}  // namespace

TEST(MissedLandmarks, CountWithTheProbabilityThatTheyAreNotDetected)
{
  const double miss = std::log(1 - kDetection);
  MissedLandmarks missed(4);
  EXPECT_NEAR(count(missed, detectionsAt({kPi / 2, kPi, 1})), miss, 1e-9) << "the one ahead, 3 m away";
  missed.clear();
  EXPECT_NEAR(count(missed, detectionsAt({kPi / 2, 0})), 2 * miss, 1e-9) << "a detection ahead that is too far away";
}

TEST(MissedLandmarks, ABearingAloneShowsALandmarkAtAnyRange)
{
  Reading reading = detectionsAt({0, kPi / 2, kPi});
  for (Detection& detection : reading.detections) detection.range.reset();
  MissedLandmarks missed(4);
  EXPECT_EQ(count(missed, reading), 0);
}

TEST(MissedLandmarks, ADetectionOfAnotherCategoryShowsNone)
{
  Reading reading = detectionsAt({0, kPi / 2, kPi});
  for (Detection& detection : reading.detections) detection.range.reset();
  reading.detections.back().category = "goal";
  MissedLandmarks missed(4);
  EXPECT_NEAR(count(missed, reading), std::log(1 - kDetection), 1e-9);
}

TEST(MissedLandmarks, WhatIsHiddenIsHiddenAgain)
{
  MissedLandmarks missed(4);
  const Reading reading = detectionsAt({kPi / 2, kPi});
  for (int readings = 0; readings < 10; ++readings)
    EXPECT_NEAR(count(missed, reading), std::log(1 - kDetection / (1 + readings)), 1e-9);
  missed.clear();
  EXPECT_NEAR(count(missed, reading), std::log(1 - kDetection), 1e-9);
}

TEST(MissedLandmarks, WhatWasSeenIsExpectedByTheNullModelToo)
{
  MissedLandmarks missed(4);
  Reading all = detectionsAt({0, kPi / 2, kPi});
  all.detections.front().range = 3;
  EXPECT_EQ(count(missed, all), 0);
  EXPECT_EQ(count(missed, detectionsAt({kPi / 2, kPi})), 0);
  missed.clear();
  EXPECT_NEAR(count(missed, detectionsAt({kPi / 2, kPi})), std::log(1 - kDetection), 1e-9);
}

TEST(MissedLandmarks, AreAveragedOverTheParticles)
{
  ParticleSet particles(Vector2d(0, 0));
  particles.add({0, 0, 0}, std::log(0.5));
  particles.add({0, 100, 0}, std::log(0.5));  // where nothing is in view
  MissedLandmarks missed(4);
  const double log_ratio = missed.count(detectionsAt({kPi / 2, kPi}), fourLandmarks(), particles);
  EXPECT_NEAR(log_ratio, std::log(0.5 * (1 - kDetection) + 0.5), 1e-9);
}

TEST(MissedLandmarks, StayFiniteWhereDetectionIsCertain)
{
  MissedLandmarks missed(4);
  EXPECT_TRUE(std::isfinite(count(missed, detectionsAt({1}, 1))));
}

TEST(MissedLandmarks, StayFiniteWhereAThousandAreMissed)
{
  const LandmarkTable map(std::vector<Landmark>(1000, {.position = {3, 0, 0}}));
  MissedLandmarks missed(map.size());
  const double log_ratio = missed.count(detectionsAt({kPi / 2}), map, robotAtOrigin());
  EXPECT_NEAR(log_ratio, 1000 * std::log(1 - kDetection), 1e-6);
}

TEST(MissedLandmarks, AReadingWithoutDetectionsTellsNothing)
{
  MissedLandmarks missed(4);
  EXPECT_EQ(count(missed, detectionsAt({})), 0);
}

// Two rooms with the same five landmarks; in the other one there are six more.
TEST(MissedLandmarks, APoseThatExpectsMoreThanIsSeenIsNotVerified)
{
  RandomStream random(7);
  const LandmarkTable here = randomMap(5, 8, random), more = randomMap(6, 8, random);
  std::vector<Landmark> landmarks = here.all();
  for (const LandmarkTable& table : {here, more})
    for (Landmark landmark : table.all())
    {
      landmark.id = static_cast<int>(landmarks.size()) + 1;
      landmark.position.x() += 60;
      landmarks.push_back(landmark);
    }
  const LandmarkTable map(landmarks);
  const SimulatedRobot robot{
      .odometry_std = {0.002, 0.002, 0.002}, .measures_range = true, .identified = false, .clutter = 0.05};
  const auto drive = [&](const Pose2& room, bool declared)
  {
    SequentialPoseTest test(motionModelOf(robot), map);
    Pose2 truth{4, 1, 0};
    double most = 0;
    for (int k = 0; k < 60; ++k)
    {
      truth = compose(truth, roundTripStep(k));
      Frame frame = simulatedFrame(robot, here, truth, roundTripStep(k), random);
      SensorModel& model = frame.readings.front().model;
      model.has_field_of_view = true;
      if (declared) model.detection_probability = 0.9;
      test.update(frame, map, particlesAt(compose(room, truth), random));
      most = std::max(most, test.logOddsAgainstChance());
    }
    return most;
  };
  EXPECT_GE(drive({}, true), SequentialPoseTest::kAcceptLogOdds);
  EXPECT_GE(drive({60, 0, 0}, false), SequentialPoseTest::kAcceptLogOdds) << "nothing tells the rooms apart";
  EXPECT_LT(drive({60, 0, 0}, true), SequentialPoseTest::kAcceptLogOdds);
}
}  // namespace mrpt_ext::test_missed_landmarks
