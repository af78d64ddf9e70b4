#include "mrpt_ext/filter/integrity/null_model.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStd = degToRad(1.0);
const MotionModel kExact{
    .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};

Reading camera()
{
  Reading reading;
  reading.sensor = "camera";
  reading.model.clutter_probability = 0.05;
  return reading;
}

Detection bearingOf(double bearing)
{
  Detection detection{.std_bearing = kStd};
  detection.bearing = bearing;
  return detection;
}

OdometryMotion aheadBy(double way) { return {{way, 0, 0}, way, 0, 1}; }

const double kEven = -std::log(kTwoPi);
}  // namespace

TEST(NullModel, TheFirstBearingMayComeFromAnywhere)
{
  NullModel world(kExact, 20);
  EXPECT_NEAR(world.take(camera(), bearingOf(1)), kEven, 1e-12);
}

TEST(NullModel, WhatIsSeenAgainIsNoSurprise)
{
  NullModel world(kExact, 20);
  double last = kEven;
  for (int k = 0; k < 10; ++k) last = world.take(camera(), bearingOf(1));
  EXPECT_EQ(world.size(), 1U);
  EXPECT_GT(last, kEven + 3);
  EXPECT_LT(world.take(camera(), bearingOf(-1)), kEven);  // new ones have become rare
  EXPECT_EQ(world.size(), 2U);
}

TEST(NullModel, ParallaxIsLearntAndThenExpected)
{
  const Vector2d post(3, 2);
  NullModel world(kExact, 20);
  std::vector<double> densities;
  for (int k = 0; k < 12; ++k)
  {
    densities.push_back(world.take(camera(), bearingOf(predictBearing({0.3 * k, 0, 0}, post))));
    world.move(aheadBy(0.3));
  }
  EXPECT_EQ(world.size(), 1U);
  EXPECT_GT(densities[11], densities[1]);
  EXPECT_GT(densities[11], kEven + 3);
}

TEST(NullModel, ItsDensityIsOne)
{
  NullModel world(kExact, 20);
  for (int k = 0; k < 4; ++k)
    for (const Vector2d& post : {Vector2d(3, 2), Vector2d(4, -1)})
    {
      (void)world.take(camera(), bearingOf(predictBearing({0.3 * k, 0, 0}, post)));
      world.move(aheadBy(0.15));
    }
  double sum = 0;
  constexpr int kSteps = 3600;
  for (int k = 0; k < kSteps; ++k)
  {
    NullModel asked = world;
    sum += std::exp(asked.take(camera(), bearingOf(-kPi + (k + 0.5) * kTwoPi / kSteps))) * kTwoPi / kSteps;
  }
  EXPECT_NEAR(sum, 1, 0.01);
}

TEST(NullModel, BearingsWithoutAnyOrderGainNothing)
{
  RandomStream random(3);
  NullModel world(kExact, 20);
  double gained = 0;
  for (int k = 0; k < 200; ++k)
  {
    gained += world.take(camera(), bearingOf(random.uniform(-kPi, kPi))) - kEven;
    world.move(aheadBy(0.3));
  }
  EXPECT_LT(gained, 5);
}

TEST(NullModel, ThingsOfAnotherKindOrSensorAreNotExpected)
{
  NullModel world(kExact, 20);
  for (int k = 0; k < 10; ++k) (void)world.take(camera(), bearingOf(1));
  Detection post = bearingOf(1);
  post.category = "post";
  EXPECT_NEAR(world.take(camera(), post), kEven, 1e-9);
  Reading other = camera();
  other.sensor = "other";
  EXPECT_NEAR(world.take(other, bearingOf(1)), kEven, 1e-9);
  world.clear();
  EXPECT_EQ(world.size(), 0U);
}
}  // namespace mrpt_ext
