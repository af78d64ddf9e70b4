#include "mrpt_ext/likelihood/missed_detections.h"

#include <gtest/gtest.h>

#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_missed_detections
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {2, 0, 0}}, {.id = 2, .position = {0, 2, 0}}});

Reading omniReading(std::vector<Detection> detections)
{
  Reading reading;
  reading.sensor = "camera";
  reading.model = {.max_range = 4.0, .detection_probability = 0.9, .has_field_of_view = true};
  reading.detections = std::move(detections);
  return reading;
}

Detection seen(int id, double bearing) { return {.id = id, .bearing = bearing, .std_bearing = 0.02}; }
}  // namespace

TEST(MissedDetections, NeedAllDeclarations)
{
  Reading reading = omniReading({});
  EXPECT_TRUE(scoresMissedDetections(reading));
  reading.model.has_field_of_view = false;
  EXPECT_FALSE(scoresMissedDetections(reading));
  reading = omniReading({});
  reading.model.max_range.reset();
  EXPECT_FALSE(scoresMissedDetections(reading));
}

TEST(MissedDetections, SeeingNothingTellsTheSameOfNamelessLandmarks)
{
  const LandmarkTable anonymous({{.position = {2, 0, 0}}, {.position = {0, 2, 0}}});
  const Pose2 in_view{0, 0, 0}, far_away{50, 50, 0};
  const Reading nothing = omniReading({});
  EXPECT_DOUBLE_EQ(logLikelihood(nothing, anonymous, in_view), logLikelihood(nothing, kMap, in_view));
  EXPECT_NEAR(logLikelihood(nothing, anonymous, in_view), 2 * std::log(0.1), 0.1);
  EXPECT_NEAR(logLikelihood(nothing, anonymous, far_away), 0, 0.02);
}

TEST(MissedDetections, AnUnseenLandmarkInViewCostsAboutItsMissProbability)
{
  const double both = logLikelihood(omniReading({seen(1, 0), seen(2, kPi / 2)}), kMap, {0, 0, 0});
  Reading no_missed = omniReading({seen(1, 0), seen(2, kPi / 2)});
  no_missed.model.detection_probability.reset();
  EXPECT_NEAR(both - logLikelihood(no_missed, kMap, {0, 0, 0}), 2 * std::log(0.9), 0.02);

  Reading one = omniReading({seen(1, 0)}), one_free = one;
  one_free.model.detection_probability.reset();
  EXPECT_NEAR(logLikelihood(one, kMap, {0, 0, 0}) - logLikelihood(one_free, kMap, {0, 0, 0}),
              std::log(0.9) + std::log(0.1), 0.1);
}

TEST(MissedDetections, EmptyReadingPrefersPlacesWithNothingInView)
{
  const Reading nothing = omniReading({});
  EXPECT_GT(logLikelihood(nothing, kMap, {50, 50, 0}), logLikelihood(nothing, kMap, {0, 0, 0}) + 3);
}

TEST(MissedDetections, AnonymousCountPrefersThePlaceWithThatManyInView)
{
  Detection first = seen(kNoId, 0), second = seen(kNoId, kPi / 2);
  const Reading two = omniReading({first, second});
  Reading free = two;
  free.model.detection_probability.reset();
  const auto missedTerm = [&](const Pose2& pose)
  { return logLikelihood(two, kMap, pose) - logLikelihood(free, kMap, pose); };
  EXPECT_GT(missedTerm({0, 0, 0}), missedTerm({5, 0, 0}) + 1);
  EXPECT_TRUE(std::isfinite(missedTerm({1e6, 0, 0})));
}
}  // namespace mrpt_ext::test_missed_detections
