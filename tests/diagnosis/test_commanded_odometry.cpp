#include "mrpt_ext/diagnosis/commanded_odometry.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_commanded_odometry
{
namespace
{
/// Two minutes at 20 Hz, with a new command every two seconds. `lag` [s]: of a robot that follows, 0: the commands.
Trajectory driven(double lag, double noise)
{
  constexpr double kPeriod = 0.05;
  RandomStream random(1, 5);
  Trajectory odometry{{0, {}, true}};
  Vector2d command{0, 0}, velocity{0, 0};
  for (int k = 1; k <= 2400; ++k)
  {
    if (k % 40 == 1) command = {random.uniform(0, 0.5), random.uniform(-1, 1)};
    velocity += (lag > 0 ? std::min(kPeriod / lag, 1.0) : 1) * (command - velocity);
    const Vector2d measured = (1 + noise * random.gaussian()) * velocity;
    const double turn = measured.y() * kPeriod, length = measured.x() * kPeriod;
    odometry.push_back(
        {k * kPeriod, compose(odometry.back().pose, {length * std::cos(turn / 2), length * std::sin(turn / 2), turn})});
  }
  return odometry;
}
}  // namespace

TEST(CommandedOdometry, CommandsStayTheSameAndJump)
{
  EXPECT_TRUE(isCommanded(driven(0, 0)));
  EXPECT_TRUE(isCommanded(driven(0, 0.001))) << "rounded stamps";
}

TEST(CommandedOdometry, WhatWheelsMeasureScattersOrTakesTime)
{
  EXPECT_FALSE(isCommanded(driven(0, 0.03)));
  EXPECT_FALSE(isCommanded(driven(0.3, 0.03)));
  EXPECT_FALSE(isCommanded(driven(0.5, 0)));
}

TEST(CommandedOdometry, ARobotThatRestsOrNeverChangesTellsNothing)
{
  EXPECT_FALSE(isCommanded({}));
  Trajectory rests, even;
  for (int k = 0; k < 1000; ++k)
  {
    rests.push_back({0.1 * k, {1, 2, 0.5}});
    even.push_back({0.1 * k, {0.02 * k, 0, 0}});
  }
  EXPECT_FALSE(isCommanded(rests));
  EXPECT_FALSE(isCommanded(even));
}
}  // namespace mrpt_ext::test_commanded_odometry
