#include <gtest/gtest.h>

#include "mrpt_ext/diagnosis/calibration_choice.h"
#include "recorded_choice.h"

namespace mrpt_ext::test_choice_of_odometry
{
namespace
{
using testing::DrivePlan;
using testing::has;
using testing::recorded;
using Kind = CalibrationParameter;

/// Bearings and ranges to one landmark at a time, with good odometry between them.
DrivePlan sparse()
{
  DrivePlan plan;
  plan.duration = 240;
  plan.landmarks_seen = 1;
  plan.rate = 2;
  return plan;
}
}  // namespace

TEST(CalibrationChoice, DistancesAndThoseOnArcsAreAdoptedTogether)
{
  DrivePlan plan = sparse();
  plan.std_distance_per_root_s = 0.005;
  plan.std_turn_per_root_s = 0.002;
  plan.distance_scale = 0.04;
  plan.distance_per_turn = -0.08;
  const std::vector<CalibrationUnknown> unknowns{
      {Kind::distance_scale}, {Kind::rotation_scale}, {Kind::veer}, {Kind::distance_per_turn}, {Kind::delay}};
  for (int seed = 1; seed <= 3; ++seed)
  {
    const CalibrationChoice choice = chooseCalibration(recorded(plan, seed), unknowns, {});
    EXPECT_TRUE(has(choice, Kind::distance_scale)) << seed;
    EXPECT_TRUE(has(choice, Kind::distance_per_turn)) << seed;
    EXPECT_FALSE(has(choice, Kind::rotation_scale)) << seed;
    EXPECT_FALSE(has(choice, Kind::veer)) << seed;
  }
}

TEST(CalibrationChoice, TurnsInPlaceAreApartWhereTheyErrByThemselves)
{
  DrivePlan plan = sparse();
  plan.rests = plan.pivots = true;
  plan.std_distance_per_root_s = 0.001;
  const std::vector<CalibrationUnknown> unknowns{{Kind::distance_scale}, {Kind::rotation_scale}, {Kind::pivot_scale}};
  for (const double loss : {0.0, 0.2})
  {
    plan.rotation_scale = -0.04 - loss;
    plan.pivot_scale = loss;
    for (int seed = 1; seed <= 3; ++seed)
    {
      const CalibrationChoice choice = chooseCalibration(recorded(plan, seed), unknowns, {});
      EXPECT_TRUE(has(choice, Kind::rotation_scale)) << loss;
      EXPECT_EQ(has(choice, Kind::pivot_scale), loss > 0) << loss;
      EXPECT_FALSE(has(choice, Kind::distance_scale)) << loss;
    }
  }
}

// A circle tells how far the robot comes on it, and not whether that is due to the turn.
TEST(CalibrationChoice, OnOneCurveTheScaleOfAllDistancesIsTold)
{
  DrivePlan plan = sparse();
  plan.evenly = true;
  plan.std_distance_per_root_s = 0.005;
  plan.std_turn_per_root_s = 0.002;
  plan.distance_scale = 0.04;
  const std::vector<CalibrationUnknown> unknowns{
      {Kind::distance_scale}, {Kind::rotation_scale}, {Kind::pivot_scale}, {Kind::distance_per_turn}};
  const CalibrationChoice choice = chooseCalibration(recorded(plan, 1), unknowns, {});
  EXPECT_TRUE(has(choice, Kind::distance_scale));
  EXPECT_FALSE(has(choice, Kind::distance_per_turn));
  EXPECT_FALSE(has(choice, Kind::pivot_scale));
}
}  // namespace mrpt_ext::test_choice_of_odometry
