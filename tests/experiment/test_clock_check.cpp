#include "mrpt_ext/experiment/clock_check.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_clock_check
{
namespace
{
LocalizationInput logFrom(double start, double duration)
{
  LocalizationInput input;
  input.context.rawlog_path = "my.rawlog";
  input.context.start_time = start;
  input.context.duration_s = duration;
  for (double time = start; time <= start + duration; time += 1) input.context.geometry.push_back({.time = time});
  return input;
}

Trajectory posesFrom(double start, double duration)
{
  Trajectory poses;
  for (double time = start; time <= start + duration; time += 1) poses.push_back({time, {}, true});
  return poses;
}

std::string errorOf(LocalizationInput input)
{
  return testing::messageOf<InputError>([&] { checkClocks(input); });
}
}  // namespace

TEST(ClockCheck, OdometryWithAnotherClockIsAnError)
{
  LocalizationInput input = logFrom(1000, 100);
  input.context.odometry = posesFrom(1000, 100);
  EXPECT_NO_THROW(checkClocks(input));
  input.context.odometry = posesFrom(0, 100);
  EXPECT_NE(errorOf(input).find("odometry has the times 0.0 to 100.0 s"), std::string::npos) << errorOf(input);
}

TEST(ClockCheck, OdometryThatMissesAPartIsANote)
{
  LocalizationInput input = logFrom(1000, 100);
  input.context.odometry = posesFrom(1060, 40);
  checkClocks(input);
  ASSERT_EQ(input.notes.size(), 1u);
  EXPECT_TRUE(input.notes[0].starts_with("odometry covers only 40 %")) << input.notes[0];
}

TEST(ClockCheck, OdometryThatJumpsIsANote)
{
  LocalizationInput input = logFrom(1000, 100);
  for (int k = 0; k < 100; ++k) input.log.overview.odometry.add({1000 + 0.1 * k, {k < 60 ? 8.0 : 0.5, 0, 0}});
  checkClocks(input);
  ASSERT_EQ(input.notes.size(), 1u);
  EXPECT_TRUE(input.notes[0].starts_with("odometry jumps 1 time, by up to 7.5 m, 6.0 s after the start: "))
      << input.notes[0];
}

TEST(ClockCheck, MillisecondsAreSuspected)
{
  LocalizationInput input = logFrom(0, 100'000);
  input.context.odometry = posesFrom(0, 100);
  checkClocks(input);
  ASSERT_EQ(input.notes.size(), 1u);
  EXPECT_TRUE(input.notes[0].ends_with("the times of the detections look like milliseconds, expected seconds"))
      << input.notes[0];
  LocalizationInput truth = logFrom(0, 100);
  truth.context.truth = posesFrom(1'000'000, 100'000);
  EXPECT_NE(errorOf(truth).find("the times of the truth look like milliseconds"), std::string::npos) << errorOf(truth);
}

TEST(ClockCheck, ATruthWithAnotherClockIsAnErrorForAWholeLog)
{
  LocalizationInput input = logFrom(1000, 100);
  input.context.truth = posesFrom(5000, 100);
  EXPECT_NE(errorOf(input).find("the ground truth has the times 5000.0"), std::string::npos) << errorOf(input);
  input.log.window.start = 10;
  EXPECT_NO_THROW(checkClocks(input));
}
}  // namespace mrpt_ext::test_clock_check
