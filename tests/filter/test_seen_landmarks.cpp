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

/// `share_new`, `share_each`, `is_known`: by the null model.
double score(const SeenLandmarks& seen, const Reading& reading, const LandmarkTable& map, double share_new,
             double share_each, bool is_known = false)
{
  ParticleSet robot(Vector2d(0, 0));
  robot.add({0, 0, 0}, 0);
  seen.score(reading, map, robot.origin, robot.poses(),
             {.share_new = share_new, .share_each = share_each, .new_given_detection = is_known ? 0.0 : 1.0},
             robot.log_weight);
  return double{robot.log_weight[0]};
}

constexpr double kChance = kClutter / (kTwoPi * kMaxRange);

/// Of a detection where one of `landmarks` is expected, as one of them or by chance.
double oneOf(int landmarks)
{
  const double peak = 1 / (kTwoPi * 0.02 * 0.1);
  return kChance + (1 - kClutter) * peak / landmarks;
}
}  // namespace

TEST(SeenLandmarks, BeforeAnythingWasSeenAllLandmarksAreAsLikely)
{
  EXPECT_NEAR(score({}, detectionAt(3, 0), fourLandmarks(), 0.3, 0.1), std::log(oneOf(4)), 1e-4);
}

TEST(SeenLandmarks, WhatWasSeenIsExpectedAsAFeatureOfTheNullModelIs)
{
  const LandmarkTable map = fourLandmarks();
  const Reading ahead = detectionAt(3, 0);
  SeenLandmarks seen;
  seen.add(0);
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.7), std::log(0.3 * oneOf(4) + 0.7 * oneOf(1)), 1e-4) << "the only one";
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.1), std::log(0.3 * oneOf(4) + 0.1 * oneOf(1) + 0.6 * kChance), 1e-4)
      << "one of seven";
  EXPECT_NEAR(score(seen, detectionAt(5, kPi / 2), map, 0, 0.1), std::log(kChance), 1e-3) << "another is a surprise";
  seen.add(1);
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.1), std::log(0.3 * oneOf(4) + 0.2 * oneOf(2) + 0.5 * kChance), 1e-4);
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.7), std::log(0.3 * oneOf(4) + 0.7 * oneOf(2)), 1e-4)
      << "more landmarks than features: together what is not new";
  seen.clear();
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.7), std::log(oneOf(4)), 1e-4);
}

TEST(SeenLandmarks, ABearingThatTheNullModelRecognizesShowsNoLandmarkForTheFirstTime)
{
  const LandmarkTable map = fourLandmarks();
  Reading ahead = detectionAt(3, 0);
  ahead.detections[0].range.reset();
  SeenLandmarks seen;
  const double first = score(seen, ahead, map, 0.5, 0.1, true);
  seen.add(1);
  const double other_seen = score(seen, ahead, map, 0.5, 0.1, true);
  EXPECT_NEAR(other_seen, score(seen, ahead, map, 0.5, 0.1, false) + std::log(4.0 / 3), 0.1) << "one of three";
  EXPECT_LT(other_seen, first);
  seen.add(0);
  EXPECT_LT(score(seen, ahead, map, 0.99, 0.01, true), score(seen, ahead, map, 0.99, 0.01, false) - 1)
      << "it cannot be new";
  EXPECT_NEAR(score(seen, detectionAt(3, 0), map, 0.5, 0.1, true), score(seen, detectionAt(3, 0), map, 0.5, 0.1, false),
              1e-6)
      << "ranges";
}

TEST(SeenLandmarks, OfBearingsAllSeenShareWhatIsNotNew)
{
  const LandmarkTable map = fourLandmarks();
  Reading ahead = detectionAt(3, 0);
  ahead.detections[0].range.reset();
  const double chance = kClutter / kTwoPi, peak = (1 - kClutter) / (std::sqrt(kTwoPi) * 0.02);
  SeenLandmarks seen;
  seen.add(0);
  for (const double share_each : {0.01, 0.7})
    EXPECT_NEAR(score(seen, ahead, map, 0.3, share_each), std::log(chance + (0.3 / 4 + 0.7) * peak), 1e-3);
  seen.add(1);
  EXPECT_NEAR(score(seen, ahead, map, 0.3, 0.01), std::log(chance + (0.3 / 4 + 0.7 / 2) * peak), 1e-3);
}

TEST(SeenLandmarks, OfAnotherCategoryAreNotExpected)
{
  const LandmarkTable map({{.position = {3, 0, 0}, .category = "pole"}, {.position = {0, 5, 0}, .category = "tree"}});
  Reading pole = detectionAt(3, 0);
  pole.detections[0].category = "pole";
  SeenLandmarks seen;
  seen.add(1);
  EXPECT_NEAR(score(seen, pole, map, 0.3, 0.1), std::log(oneOf(1)), 1e-4) << "no pole was seen";
  seen.add(0);
  EXPECT_NEAR(score(seen, pole, map, 0.3, 0.1), std::log(0.4 * oneOf(1) + 0.6 * kChance), 1e-4);
}
}  // namespace mrpt_ext::test_seen_landmarks
