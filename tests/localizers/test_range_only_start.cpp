#include "mrpt_ext/localizers/range_only_start.h"

#include <gtest/gtest.h>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_range_only_start
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const ExactSensor kRadio{.bearing = false, .range = true, .std_range = 0.5};

Frame frameWithRanges(double time, double distance, const ExactSensor& sensor = kRadio)
{
  return {.time = time,
          .motion = {{distance, 0, 0}, distance, 0, time > 0 ? 1.0 : 0.0},
          .readings = {seenFrom({1, 2, 0}, kMap, {0}, sensor, time)}};
}
}  // namespace

TEST(RangeOnlyStart, KeepsAllRangesPropagatedToTheNewestFrame)
{
  RangeOnlyStart history(MotionModel{});
  for (int k = 0; k < 4; ++k) history.add(frameWithRanges(k, k > 0 ? 0.2 : 0.0));
  const std::vector<Reading> all = history.readings();
  ASSERT_EQ(all.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(all[k].T_robot_sensor.x, -0.2 * (3.0 - static_cast<double>(k)), 1e-12);
}

TEST(RangeOnlyStart, EndsWithAnyOtherMeasurement)
{
  RangeOnlyStart bearing(MotionModel{}), anonymous(MotionModel{}), compass(MotionModel{});
  for (RangeOnlyStart* history : {&bearing, &anonymous, &compass}) history->add(frameWithRanges(0, 0));
  bearing.add(frameWithRanges(1, 0.1, {.range = true}));
  anonymous.add(frameWithRanges(1, 0.1, {.bearing = false, .range = true, .identified = false}));
  Frame north = frameWithRanges(1, 0.1);
  north.compass = CompassRecord{};
  compass.add(north);
  for (RangeOnlyStart* history : {&bearing, &anonymous, &compass})
  {
    history->add(frameWithRanges(2, 0.1));
    EXPECT_TRUE(history->readings().empty());
  }
}

TEST(RangeOnlyStart, IsEmptyWhileOdometryIsLessAccurateThanTheRanges)
{
  MotionModel rough;
  rough.std_xy_per_m = 0.2;  // after 4 m: 0.4 m on either axis
  RangeOnlyStart history(rough);
  history.add(frameWithRanges(0, 0));
  history.add(frameWithRanges(1, 1));
  EXPECT_EQ(history.readings().size(), 2U);
  for (int k = 2; k < 8; ++k) history.add(frameWithRanges(k, 1));
  EXPECT_TRUE(history.readings().empty());
}

TEST(RangeOnlyStart, EndsWithTooManyReadings)
{
  RangeOnlyStart history(MotionModel{});
  for (int k = 0; k < 400; ++k) history.add(frameWithRanges(0.1 * k, 0));
  EXPECT_EQ(history.readings().size(), 400U);
  history.add(frameWithRanges(40, 0));
  EXPECT_TRUE(history.readings().empty());
}

TEST(RangeOnlyStart, EndsOnRequest)
{
  RangeOnlyStart history(MotionModel{});
  history.add(frameWithRanges(0, 0));
  EXPECT_FALSE(history.readings().empty());
  history.end();
  history.add(frameWithRanges(1, 0));
  EXPECT_TRUE(history.readings().empty());
}
}  // namespace mrpt_ext::test_range_only_start
