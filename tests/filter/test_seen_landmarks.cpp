#include "mrpt_ext/filter/integrity/seen_landmarks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext::test_seen_landmarks
{
namespace
{
constexpr double kClutter = 0.1, kMaxRange = 20;

/// Four landmarks, the first of them 3 m ahead of a robot at the origin.
LandmarkTable fourLandmarks()
{
  return LandmarkTable(
      {{.position = {3, 0, 0}}, {.position = {0, 5, 0}}, {.position = {-4, 0, 0}}, {.position = {0, -6, 0}}});
}

Reading detectionAt(double range, double bearing)
{
  Reading reading;
  reading.model.clutter_probability = kClutter;
  reading.model.max_range = kMaxRange;
  reading.detections = {{.bearing = bearing, .range = range, .std_bearing = 0.02, .std_range = 0.1}};
  return reading;
}

double score(const SeenLandmarks& seen, const Reading& reading, const LandmarkTable& map)
{
  ParticleSet robot(Vector2d(0, 0));
  robot.add({0, 0, 0}, 0);
  seen.score(reading, map, robot.origin, robot.poses(), robot.log_weight);
  return double{robot.log_weight[0]};
}

/// Of a detection where one of `landmarks` is expected, as one of them or by chance.
double oneOf(int landmarks)
{
  const double peak = 1 / (kTwoPi * 0.02 * 0.1);
  return kClutter / (kTwoPi * kMaxRange) + (1 - kClutter) * peak / landmarks;
}
}  // namespace

TEST(SeenLandmarks, BeforeAnythingWasSeenAllLandmarksAreAsLikely)
{
  EXPECT_NEAR(score({}, detectionAt(3, 0), fourLandmarks()), std::log(oneOf(4)), 1e-4);
}

TEST(SeenLandmarks, WhatWasSeenIsExpectedAgain)
{
  const LandmarkTable map = fourLandmarks();
  SeenLandmarks seen;
  seen.count(0);  // one detection of something new: the next one is new with probability (1 + 1) / (1 + 2)
  EXPECT_NEAR(score(seen, detectionAt(3, 0), map), std::log(oneOf(4) * 2 / 3 + oneOf(1) / 3), 1e-4);
  for (int k = 0; k < 997; ++k) seen.count(0);
  EXPECT_NEAR(score(seen, detectionAt(3, 0), map), std::log(oneOf(1)), 0.01);
  EXPECT_LT(score(seen, detectionAt(5, kPi / 2), map), std::log(oneOf(4) / 100)) << "another one is a surprise";
  seen.clear();
  EXPECT_NEAR(score(seen, detectionAt(3, 0), map), std::log(oneOf(4)), 1e-4);
}

TEST(SeenLandmarks, AddingALandmarkIsNoSurprise)
{
  SeenLandmarks added, counted;
  added.add(0);
  added.count(0);
  counted.count(0);
  const LandmarkTable map = fourLandmarks();
  EXPECT_GT(score(added, detectionAt(3, 0), map), score(counted, detectionAt(3, 0), map));
  counted.count({});
  EXPECT_NEAR(score(counted, detectionAt(3, 0), map), std::log(oneOf(4) * 2 / 3 + oneOf(1) / 3), 1e-4)
      << "clutter is no landmark";
}
}  // namespace mrpt_ext::test_seen_landmarks
