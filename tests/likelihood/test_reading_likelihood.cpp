#include "mrpt_ext/likelihood/reading_likelihood.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

namespace mrpt_ext::test_reading_likelihood
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {3, 0, 0}, .category = "red"},
                          {.id = 2, .position = {0, 4, 0}, .category = "blue"},
                          {.id = 3, .position = {-3, -1, 0}, .category = "red"}});
constexpr double kClutter = 0.1;

Reading withDetection(const Detection& detection)
{
  Reading reading;
  reading.sensor = "s";
  reading.model = {.max_range = 20.0, .clutter_probability = kClutter};
  reading.detections = {detection};
  return reading;
}

double gaussian(double residual, double std)
{
  return std::exp(-0.5 * square(residual / std)) / (std * std::sqrt(kTwoPi));
}

/// Integral of the likelihood over everything a bearing-only detection can measure.
double integralOverBearings(Detection detection, const Pose2& pose)
{
  const int n = 20000;
  double sum = 0;
  for (int i = 0; i < n; ++i)
  {
    detection.bearing = -kPi + (i + 0.5) * kTwoPi / n;
    sum += std::exp(logLikelihood(withDetection(detection), kMap, pose));
  }
  return sum * kTwoPi / n;
}
}  // namespace

TEST(ReadingLikelihood, BullsEyeAndOneSigmaOff)
{
  const Detection exact{.id = 1, .bearing = 0.0, .std_bearing = 0.1};
  const double clutter = kClutter / kTwoPi;
  EXPECT_NEAR(logLikelihood(withDetection(exact), kMap, {0, 0, 0}), std::log(0.9 * gaussian(0, 0.1) + clutter), 1e-12);
  for (const double heading : {0.1, -0.1})
    EXPECT_NEAR(logLikelihood(withDetection(exact), kMap, {0, 0, heading}),
                std::log(0.9 * gaussian(0.1, 0.1) + clutter), 1e-9);
}

TEST(ReadingLikelihood, ResidualsWrap)
{
  const Detection behind{.id = 1, .bearing = kPi - 0.05, .std_bearing = 0.1};
  EXPECT_NEAR(logLikelihood(withDetection(behind), kMap, {0, 0, kPi - 0.05}),
              std::log(0.9 * gaussian(0.1, 0.1) + kClutter / kTwoPi), 1e-9);
}

TEST(ReadingLikelihood, RangeUsesItsOwnVolume)
{
  const Detection range{.id = 2, .range = 4.2, .std_range = 0.2};
  EXPECT_NEAR(logLikelihood(withDetection(range), kMap, {0, 0, 1}),
              std::log(0.9 * gaussian(0.2, 0.2) + kClutter / 20.0), 1e-12);
}

TEST(ReadingLikelihood, IsNormalisedForKnownCategoryAndAnonymous)
{
  const Pose2 pose{0.7, -0.4, 0.9};
  EXPECT_NEAR(integralOverBearings({.id = 1, .std_bearing = 0.05}, pose), 1, 1e-3);
  EXPECT_NEAR(integralOverBearings({.category = "red", .std_bearing = 0.05}, pose), 1, 1e-3);
  EXPECT_NEAR(integralOverBearings({.std_bearing = 0.05}, pose), 1, 1e-3);
}

TEST(ReadingLikelihood, UnknownIdIsClutterEverywhere)
{
  const Detection stranger{.id = 99, .bearing = 0.3, .std_bearing = 0.05};
  EXPECT_NEAR(logLikelihood(withDetection(stranger), kMap, {0, 0, 0}), -std::log(kTwoPi), 1e-12);
  EXPECT_NEAR(logLikelihood(withDetection(stranger), kMap, {5, 1, 2}), -std::log(kTwoPi), 1e-12);
}

TEST(ReadingLikelihood, CategoryLimitsTheCandidates)
{
  const Detection blue{.category = "blue", .bearing = 0.0, .std_bearing = 0.05};
  Detection red = blue;
  red.category = "red";
  EXPECT_GT(logLikelihood(withDetection(red), kMap, {0, 0, 0}),
            logLikelihood(withDetection(blue), kMap, {0, 0, 0}) + 2);
}

TEST(ReadingLikelihood, OneWrongDetectionCannotKillAPose)
{
  Reading reading = withDetection({.id = 1, .bearing = 0.0, .std_bearing = 1e-4});
  EXPECT_GT(logLikelihood(reading, kMap, {0, 0, 2}), -10);
  reading.model.clutter_probability = 0;
  EXPECT_TRUE(std::isfinite(logLikelihood(reading, kMap, {0, 0, 2})));
  EXPECT_TRUE(std::isfinite(logLikelihood(reading, kMap, {1e9, -1e9, 2})));
}

TEST(ReadingLikelihood, AFaultyLandmarkIsTrustedLess)
{
  const Reading reading = withDetection({.id = 1, .range = 3.0, .std_range = 0.1});
  const double trusted = logLikelihood(reading, kMap, {0, 0, 0}, {0.01, 0.01, 0.01});
  const double doubted = logLikelihood(reading, kMap, {0, 0, 0}, {0.5, 0.01, 0.01});
  EXPECT_NEAR(trusted, std::log(0.99 * gaussian(0, 0.1) + 0.01 / 20), 1e-12);
  EXPECT_NEAR(doubted, std::log(0.5 * gaussian(0, 0.1) + 0.5 / 20), 1e-12);
}

TEST(ReadingLikelihood, AssociationNamesTheLandmark)
{
  const Reading reading = withDetection({.bearing = kPi / 2, .std_bearing = 0.02});
  const auto probabilities = associationProbabilities(reading, kMap, {}, {0, 0, 0});
  EXPECT_GT(probabilities[0][1], 0.95);
  EXPECT_LT(probabilities[0][0], 1e-6);
  EXPECT_LE(std::accumulate(probabilities[0].begin(), probabilities[0].end(), 0.0), 1.0);
}

RC_GTEST_PROP(ReadingLikelihood, BatchEqualsSingleAndIsFinite, (int seed))
{
  PoseColumns robots({3, -2});
  for (int i = 0; i < 7; ++i) robots.add({(seed % 97) * 0.1 + i, (seed % 89) * 0.1 - i, wrap((seed % 83) * 0.07 + i)});
  Reading reading = withDetection({.bearing = 0.4, .range = 3.3, .std_bearing = 0.03, .std_range = 0.2});
  reading.detections.push_back({.id = 3, .bearing = 1.0, .std_bearing = 0.03});
  reading.model.has_field_of_view = true;
  reading.model.detection_probability = 0.8;
  const PoseBatch poses = robots.batch();
  std::vector<float> batch(poses.size(), 0.0F);
  addLogLikelihood(reading, kMap, {}, poses, batch);
  for (std::size_t i = 0; i < poses.size(); ++i)
  {
    RC_ASSERT(std::isfinite(batch[i]));
    RC_ASSERT(std::abs(double{batch[i]} - logLikelihood(reading, kMap, poses[i])) < 1e-4);
  }
}
}  // namespace mrpt_ext::test_reading_likelihood
