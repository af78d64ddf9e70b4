#include "mrpt_ext/likelihood/facing_likelihood.h"

#include <gtest/gtest.h>

#include <vector>

#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_facing_likelihood
{
namespace
{
constexpr double kWallFaces = 2.5;
const Pose2 kMount{0.2, -0.1, 0.4};

/// A landmark of known direction, one whose direction is not known, and one known to 0.3 rad.
LandmarkTable map()
{
  return LandmarkTable({{.id = 1, .position = {4, 1, 0}, .yaw = kWallFaces},
                        {.id = 2, .position = {0, 5, 0}},
                        {.id = 3, .position = {3, 5, 0}, .yaw = -1.0, .std_yaw = 0.3}});
}

/// Sees a landmark face `facing`.
Reading readingOf(int id, const std::optional<Facing>& facing, double clutter = 0.05)
{
  Reading reading{.sensor = "camera", .T_robot_sensor = kMount};
  reading.model.clutter_probability = clutter;
  reading.detections = {{.id = id, .bearing = 0.2, .std_bearing = 0.01, .facing = facing}};
  return reading;
}

/// What a sensor of a robot with this heading sees.
double seenYaw(double heading) { return wrap(kWallFaces - heading - kMount.phi); }

double density(const Reading& reading, double heading)
{
  return std::exp(facingLogLikelihood(reading, map(), {1, 2, heading}));
}
}  // namespace

TEST(FacingLikelihood, TheHeadingFollowsFromTheDirectionInTheMap)
{
  const auto headings =
      headingFromFacing(readingOf(1, Facing::single(seenYaw(-2.8), 0.05)).detections[0], readingOf(1, {}), map());
  ASSERT_TRUE(headings);
  EXPECT_NEAR(headings->attitudes[0].yaw, -2.8, 1e-12);
  EXPECT_EQ(headings->attitudes[0].std, 0.05);
}

TEST(FacingLikelihood, TheMapsDeviationIsAdded)
{
  const Reading reading = readingOf(3, Facing::single(0, 0.4));
  EXPECT_NEAR(headingFromFacing(reading.detections[0], reading, map())->attitudes[0].std, 0.5, 1e-12);
}

TEST(FacingLikelihood, AnOffsetOfTheBearingsTurnsDirectionsAsWell)
{
  const Reading reading = readingOf(1, Facing::single(seenYaw(0.7) + 0.1, 0.05), 0.01);
  EXPECT_NEAR(facingLogLikelihood(reading, map(), {0, 0, 0.7}, {.bearing_offset = 0.1}),
              std::log(0.99 / (0.05 * std::sqrt(kTwoPi)) + 0.01 / kTwoPi), 1e-9);
}

TEST(FacingLikelihood, IsNormalisedOverWhatIsSeen)
{
  const int n = 20000;
  for (const double std : {0.01, 0.1, 0.5})
    for (const double heading : {-3.1, 0.4, 3.1})
    {
      double sum = 0;
      for (int i = 0; i < n; ++i)
      {
        const double yaw = -kPi + (i + 0.5) * kTwoPi / n;
        sum += density(readingOf(1, Facing::either({yaw, std}, {yaw + 0.8, 2 * std}, 0.3)), heading);
      }
      EXPECT_NEAR(sum * kTwoPi / n, 1, 2e-3) << std << ' ' << heading;  // tails beyond half a turn
    }
}

TEST(FacingLikelihood, GoldenMixture)
{
  // (1 - 0.1) (0.75 N(0; 0.2) + 0.25 N(0.5 - 0.1; 0.3)) + 0.1 / 2 pi, off by 0.1 from the first.
  const Reading reading = readingOf(1, Facing::either({seenYaw(0.3) + 0.1, 0.2}, {seenYaw(0.3) - 0.4, 0.3}, 0.25), 0.1);
  const double first = std::exp(-0.125) / (0.2 * std::sqrt(kTwoPi)),
               second = std::exp(-0.5 * square(0.4 / 0.3)) / (0.3 * std::sqrt(kTwoPi));
  EXPECT_NEAR(density(reading, 0.3), 0.9 * (0.75 * first + 0.25 * second) + 0.1 / kTwoPi, 1e-12);
}

TEST(FacingLikelihood, FarOffItIsClutter)
{
  EXPECT_NEAR(density(readingOf(1, Facing::single(seenYaw(0.3), 0.001)), 2.0), 0.05 / kTwoPi, 1e-12);
}

TEST(FacingLikelihood, WithoutADirectionInImageOrMapItIsNoFactor)
{
  EXPECT_EQ(facingLogLikelihood(readingOf(1, {}), map(), {}), 0);
  EXPECT_EQ(facingLogLikelihood(readingOf(2, Facing::single(0, 0.1)), map(), {}), 0);
  EXPECT_EQ(facingLogLikelihood(readingOf(7, Facing::single(0, 0.1)), map(), {}), 0);
  EXPECT_EQ(facingLogLikelihood(readingOf(kNoId, Facing::single(0, 0.1)), map(), {}), 0);
  PoseColumns robots;
  robots.add({1, 2, 0.5});
  std::vector<float> with{0.25F}, without{0.25F};
  addLogLikelihood(readingOf(2, Facing::single(0, 0.1)), map(), {}, robots.batch(), with);
  addLogLikelihood(readingOf(2, {}), map(), {}, robots.batch(), without);
  EXPECT_EQ(with, without);
}

TEST(FacingLikelihood, ManyRobotsAreScoredAsOne)
{
  const Reading reading = readingOf(1, Facing::either({seenYaw(0.3), 0.1}, {seenYaw(0.9), 0.2}, 0.4));
  const std::vector<BiasState> states{{.kind = BiasKind::bearing_offset, .std = 0.1}};
  PoseColumns robots({2, 2});
  std::vector<float> offsets;
  for (const double heading : {-3.0, 0.25, 0.8, 2.9})
  {
    robots.add({1, 2, heading});
    offsets.push_back(static_cast<float>(0.02 * heading));
  }
  PoseBatch batch = robots.batch();
  batch.bias_states = states;
  batch.bias = {offsets};
  std::vector<float> log_likelihood(batch.size(), -1.0F);
  addFacingLogLikelihood(reading, map(), batch, log_likelihood);
  for (std::size_t i = 0; i < batch.size(); ++i)
    EXPECT_NEAR(log_likelihood[i],
                -1 + facingLogLikelihood(reading, map(), batch[i], {.bearing_offset = double{offsets[i]}}), 1e-4);
}

TEST(FacingLikelihood, IsAFactorBesideBearingAndRange)
{
  const Reading with = readingOf(1, Facing::single(seenYaw(0.3), 0.1)), without = readingOf(1, {});
  const Pose2 robot{1, 2, 0.35};
  const double factor = facingLogLikelihood(with, map(), robot);
  EXPECT_NEAR(logLikelihood(with, map(), robot), logLikelihood(without, map(), robot) + factor, 1e-12);
  PoseColumns robots;
  robots.add(robot);
  std::vector<float> batch{0};
  addLogLikelihood(with, map(), {}, robots.batch(), batch);
  EXPECT_NEAR(batch[0], logLikelihood(with, map(), robot), 1e-4);
}
}  // namespace mrpt_ext::test_facing_likelihood
