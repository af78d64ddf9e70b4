#include "mrpt_ext/vision/tags/tag_facing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/vision/tags/tag_measurement.h"
#include "tag_picture.h"
#include "test_length.h"

namespace mrpt_ext::test_tag_facing
{
namespace
{
using testing::PlacedTag;
using testing::wallCamera;

/// A tag that is not turned faces the camera.
double facingOf(const PlacedTag& tag) { return wrap(tag.bearing + tag.turned + kPi); }

TagCorners shaken(TagCorners corners, double std_corner, RandomStream& random)
{
  for (Eigen::Vector2d& corner : corners) corner += std_corner * Eigen::Vector2d(random.gaussian(), random.gaussian());
  return corners;
}

std::optional<Facing> seen(const TagCorners& corners, const TagNoise& noise)
{
  return mrpt_ext::facingOf(posesOfTag(corners, 0.2, wallCamera(), noise), corners, 0.2, wallCamera(), noise);
}

/// Sums over shaken images of one tag.
struct Tally
{
  double squared = 0;      ///< errors of the attitudes that the truth belongs to, in units of the stated variance
  double range_error = 0;  ///< products of the errors of direction and range
  double squared_range = 0, squared_yaw = 0;
  double first = 0, first_right = 0;  ///< stated probability of the first attitude; how often the truth belongs to it
  int count = 0;

  void add(const TagMeasurement& measured, const PlacedTag& tag)
  {
    const auto& [one, other] = measured.facing->attitudes;
    const auto deviation = [&](const Facing::Attitude& a)
    { return a.weight > 0 ? wrap(a.yaw - facingOf(tag)) / a.std : 1e9; };
    const auto density = [&](const Facing::Attitude& a)
    { return a.weight > 0 ? a.weight / a.std * std::exp(-0.5 * square(deviation(a))) : 0.0; };
    const double of_one = density(one) / (density(one) + density(other));
    const Facing::Attitude& own = of_one > 0.5 ? one : other;
    const double yaw_error = wrap(own.yaw - facingOf(tag)), error = measured.range - tag.range;
    // Between two attitudes the truth belongs to both: to the nearer one alone it would seem too near.
    squared += of_one * square(deviation(one)) + (of_one < 1 ? (1 - of_one) * square(deviation(other)) : 0);
    range_error += yaw_error * error, squared_range += square(error), squared_yaw += square(yaw_error);
    first += one.weight, first_right += of_one;
    ++count;
  }
  [[nodiscard]] double nees() const { return squared / count; }
  [[nodiscard]] double correlation() const { return range_error / std::sqrt(squared_range * squared_yaw); }
};

Tally tallyOf(const PlacedTag& tag, double std_corner, int trials, RandomStream& random)
{
  const PinholeCamera camera = wallCamera();
  Tally tally;
  for (int trial = 0; trial < trials; ++trial)
  {
    const auto measured =
        measureTag(shaken(tag.corners(camera), std_corner, random), tag.edge, camera, {.std_corner = std_corner});
    EXPECT_TRUE(measured && measured->facing);
    if (measured && measured->facing) tally.add(*measured, tag);
  }
  return tally;
}
}  // namespace

TEST(TagFacing, ExactCornersGiveTheExactDirection)
{
  for (const double turned : {-1.0, -0.4, 0.5, 1.1})
  {
    const PlacedTag tag{.range = 1.2, .bearing = 0.3, .turned = turned};
    const auto facing = seen(tag.corners(wallCamera()), {.std_corner = 0.02});
    ASSERT_TRUE(facing);
    EXPECT_NEAR(facing->attitudes[0].yaw, facingOf(tag), 2e-4) << turned;
    EXPECT_GT(facing->attitudes[0].weight, 0.9999);
  }
}

TEST(TagFacing, FarAwayTheOtherSideOfTheLineOfSightIsPossible)
{
  const PlacedTag tag{.range = 5, .bearing = 0.1, .above = 0.1, .turned = 0.7};
  const auto facing = seen(tag.corners(wallCamera()), {});
  ASSERT_TRUE(facing);
  const auto& [first, second] = facing->attitudes;
  EXPECT_NEAR(first.yaw, facingOf(tag), 0.05);
  EXPECT_NEAR(second.yaw, wrap(tag.bearing - tag.turned + kPi), 0.2);
  EXPECT_GT(second.weight, 0.05);
  EXPECT_NEAR(first.weight + second.weight, 1, 1e-12);
}

TEST(TagFacing, ATagAboveTheCameraIsLessAmbiguous)
{
  // An upright tag, seen from below, is skewed one way or the other.
  const auto other = [](double above)
  {
    const PlacedTag tag{.range = 4, .bearing = 0, .above = above, .turned = 0.7};
    return seen(tag.corners(wallCamera()), {})->attitudes[1].weight;
  };
  EXPECT_LT(other(1.2), 0.1 * other(0.05));
}

TEST(TagFacing, WhatLiesFlatFacesNowhere)
{
  PinholeCamera camera = wallCamera();
  const Eigen::Matrix3d to_camera = camera.levelAxes().transpose();
  TagCorners corners;
  const std::array<Eigen::Vector3d, 4> arms{Eigen::Vector3d(1, 1, 0), {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = camera.project(to_camera * (Eigen::Vector3d(1, 0, -0.3) + 0.1 * arms[i])).value().pixel;
  const TagNoise anyhow{.std_corner = 0.1, .std_upright = 1e3};
  ASSERT_FALSE(posesOfTag(corners, 0.2, camera, anyhow).empty());
  EXPECT_FALSE(seen(corners, anyhow));
}

TEST(TagFacing, StatedDeviationsAndProbabilitiesAgreeWithTheScatter)
{
  RandomStream random(5);
  const int trials = testing::runsOfTest(200);
  double sum = 0, count = 0, stated = 0, right = 0;
  for (const double std_corner : {0.1, 0.5})
    for (const double range : {1.0, 2.0, 3.0, 4.5, 6.0})
      for (const double turned : {-0.9, -0.6, -0.3, -0.15, 0.0, 0.2, 0.4, 0.7, 1.1})
      {
        const PlacedTag tag{.range = range, .bearing = 0.2 - 0.3 * turned, .above = 0.4, .turned = turned};
        const Tally tally = tallyOf(tag, std_corner, trials, random);
        // Of one direction: the likelihood averages over all. Tags seen from the front state too much or too little.
        if (!testing::isShort())
        {
          EXPECT_GT(tally.nees(), 0.4) << std_corner << " px, " << range << " m, " << turned;
          EXPECT_LT(tally.nees(), 2) << std_corner << " px, " << range << " m, " << turned;
        }
        sum += tally.squared, count += tally.count, stated += tally.first, right += tally.first_right;
      }
  EXPECT_NEAR(sum / count, 1, testing::isShort() ? 0.3 : 0.07);
  EXPECT_NEAR(stated / count, right / count, testing::isShort() ? 0.1 : 0.02);
}

TEST(TagFacing, AFrontalTagHasTheDeviationOfItsLikelihood)
{
  // The image hardly changes with small turns: a parabola about the maximum would state several times too little or too
  // much.
  RandomStream random(9);
  const Tally tally = tallyOf({.range = 4.5, .above = 0.4, .turned = 0}, 0.5, testing::runsOfTest(400), random);
  EXPECT_NEAR(tally.nees(), 1, testing::isShort() ? 0.6 : 0.35);
}
}  // namespace mrpt_ext::test_tag_facing
