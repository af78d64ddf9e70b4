#include "mrpt_ext/calibration/self_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "recorded_drive.h"
#include "test_length.h"

namespace mrpt_ext::test_self_calibration
{
namespace
{
using testing::DrivePlan;
using testing::recordedDrive;
using Kind = CalibrationParameter;

const std::vector<CalibrationUnknown> kAll{{Kind::delay},       {Kind::bearing_offset}, {Kind::range_offset},
                                           {Kind::range_scale}, {Kind::distance_scale}, {Kind::rotation_scale},
                                           {Kind::veer}};
const std::vector<CalibrationUnknown> kOfRanges{{Kind::delay},          {Kind::range_offset},   {Kind::range_scale},
                                                {Kind::distance_scale}, {Kind::rotation_scale}, {Kind::veer}};

double trueValue(const DrivePlan& plan, Kind kind)
{
  switch (kind)
  {
    case Kind::delay:
      return plan.delay;
    case Kind::bearing_offset:
      return plan.bearing_offset;
    case Kind::bearing_scale:
      return plan.bearing_scale;
    case Kind::range_axis:
      return plan.range_axis;
    case Kind::range_offset:
      return plan.range_offset;
    case Kind::range_scale:
      return plan.range_scale;
    case Kind::range_height:
      return square(plan.height);
    case Kind::landmark_offset:
    case Kind::landmark_x:
    case Kind::landmark_y:
      break;  // a value per landmark
    case Kind::distance_scale:
      return plan.distance_scale;
    case Kind::distance_per_turn:
      return plan.distance_per_turn;
    case Kind::rotation_scale:
      return plan.rotation_scale;
    case Kind::pivot_scale:
      return plan.pivot_scale;
    case Kind::veer:
      return plan.veer;
    case Kind::lever_arm_x:
      return plan.lever_arm.x();
    case Kind::lever_arm_y:
      return plan.lever_arm.y();
    case Kind::drift:
      return plan.drift;
  }
  return 0;
}

const ParameterEstimate& errorOf(const CalibrationResult& found, Kind kind)
{
  for (const ParameterEstimate& error : found.errors)
    if (error.unknown.parameter == kind) return error;
  throw std::logic_error("not asked for");
}

DrivePlan erroneous()
{
  DrivePlan plan;
  plan.delay = 0.12;
  plan.bearing_offset = degToRad(2.0);
  plan.range_offset = 0.2;
  plan.range_scale = 0.04;
  plan.distance_scale = -0.05;
  plan.rotation_scale = 0.07;
  plan.veer = -0.03;
  return plan;
}

/// Mean of the squared errors in deviations, over drives of several seeds; every error must be told and within four.
double meanSquareOverVariance(const DrivePlan& plan, const std::vector<CalibrationUnknown>& terms, int drives)
{
  double sum = 0;
  int count = 0;
  for (int seed = 1; seed <= drives; ++seed)
  {
    RandomStream random(static_cast<std::uint64_t>(seed), 7);
    const CalibrationResult found = calibrate(recordedDrive(plan, random), terms);
    EXPECT_EQ(found.status, SolveStatus::ok);
    for (const ParameterEstimate& error : found.errors)
    {
      EXPECT_TRUE(error.observable) << static_cast<int>(error.unknown.parameter) << " +- " << error.std;
      const double off = (error.value - trueValue(plan, error.unknown.parameter)) / error.std;
      EXPECT_LT(std::abs(off), 4) << static_cast<int>(error.unknown.parameter) << ": " << error.value << " +- "
                                  << error.std;
      sum += square(off);
      ++count;
    }
  }
  return sum / count;
}
}  // namespace

TEST(CalibrationResult, AllAreFoundWithHonestDeviations)
{
  const double consistency = meanSquareOverVariance(erroneous(), kAll, testing::runsOfTest(6));
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(consistency, 0.5);
  EXPECT_LT(consistency, 1.6);
}

TEST(CalibrationResult, AxisAndFocalLengthOfACameraAreNoLeverArms)
{
  const DrivePlan plan = testing::cameraDrive();
  std::vector<CalibrationUnknown> unknowns{{Kind::lever_arm_x}, {Kind::lever_arm_y},   {Kind::bearing_offset},
                                           {Kind::range_scale}, {Kind::bearing_scale}, {Kind::range_axis}};
  RandomStream random(3, 7);
  const CalibrationProblem problem = testing::asRanges(recordedDrive(plan, random));
  const CalibrationResult found = calibrate(problem, unknowns);
  ASSERT_EQ(found.status, SolveStatus::ok);
  for (const ParameterEstimate& error : found.errors)
    EXPECT_LT(std::abs(error.value - trueValue(plan, error.unknown.parameter)), 4 * error.std)
        << static_cast<int>(error.unknown.parameter) << ": " << error.value << " +- " << error.std;
  EXPECT_TRUE(errorOf(found, Kind::bearing_scale).observable);
  EXPECT_TRUE(errorOf(found, Kind::range_axis).observable);
  EXPECT_LT(errorOf(found, Kind::range_axis).std, degToRad(0.5));

  unknowns.resize(4);  // without these two, places take the blame
  const CalibrationResult before = calibrate(problem, unknowns);
  EXPECT_GT(errorOf(before, Kind::lever_arm_y).value, 4 * errorOf(before, Kind::lever_arm_y).std);
}

// By 5 % on the mean curve, and by 15 % where it is narrowest.
TEST(CalibrationResult, ARobotThatFallsBehindOnArcsIsToldFromOneThatAlwaysDoes)
{
  DrivePlan plan;
  plan.std_distance_per_root_s = 0.005;
  plan.std_turn_per_root_s = 0.002;
  plan.distance_scale = 0.05;
  plan.distance_per_turn = -0.08;
  plan.veer = 0.02;
  const std::vector<CalibrationUnknown> unknowns{
      {Kind::distance_scale}, {Kind::distance_per_turn}, {Kind::rotation_scale}, {Kind::veer}, {Kind::delay}};
  const double consistency = meanSquareOverVariance(plan, unknowns, testing::runsOfTest(6));
  RandomStream random(1, 7);
  const CalibrationProblem problem = recordedDrive(plan, random);
  const CalibrationResult found = calibrate(problem, unknowns);
  EXPECT_LT(errorOf(found, Kind::distance_per_turn).std, 0.008);
  // Without it the distance takes the mean of both, and the rest passes for noise.
  const CalibrationResult without = calibrate(problem, {{Kind::distance_scale}, {Kind::rotation_scale}, {Kind::delay}});
  EXPECT_LT(errorOf(without, Kind::distance_scale).value, 0.02);
  EXPECT_GT(without.odometry_scatter[position_noise], 1.5 * found.odometry_scatter[position_noise]);
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(consistency, 0.5);
  EXPECT_LT(consistency, 1.6);
}

TEST(CalibrationResult, ArcsThatTurnLessThanTurnsInPlaceAreTold)
{
  DrivePlan plan;
  plan.rests = plan.pivots = true;
  plan.std_distance_per_root_s = 0.001;
  plan.rotation_scale = -0.3;
  plan.pivot_scale = 0.32;
  const std::vector<CalibrationUnknown> unknowns{{Kind::distance_scale}, {Kind::rotation_scale}, {Kind::pivot_scale}};
  const double consistency = meanSquareOverVariance(plan, unknowns, testing::runsOfTest(6));
  plan.pivots = false;
  RandomStream random(1, 7);
  const CalibrationResult without = calibrate(recordedDrive(plan, random), unknowns);
  EXPECT_FALSE(errorOf(without, Kind::pivot_scale).observable);
  EXPECT_NEAR(errorOf(without, Kind::rotation_scale).value, plan.rotation_scale, 0.01);
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(consistency, 0.4);
  EXPECT_LT(consistency, 1.8);
}

TEST(CalibrationResult, AreFoundFromOneRangeAtATime)
{
  DrivePlan plan = erroneous();
  plan.bearings = false;
  plan.landmarks_seen = 1;
  plan.duration = 200;
  const double consistency = meanSquareOverVariance(plan, kOfRanges, testing::runsOfTest(5));
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(consistency, 0.3);
  EXPECT_LT(consistency, 2);
}

TEST(CalibrationResult, DelaysOfEitherSignAreFound)
{
  for (const double delay : {-0.6, -0.05, 0.3, 0.9})
  {
    DrivePlan plan;
    plan.duration = 60;
    plan.delay = delay;
    RandomStream random(3);
    const CalibrationResult found = calibrate(recordedDrive(plan, random), kAll);
    const ParameterEstimate& error = errorOf(found, Kind::delay);
    EXPECT_TRUE(error.observable);
    EXPECT_NEAR(error.value, delay, 0.02);
    EXPECT_LT(error.std, 0.012);
  }
}

TEST(CalibrationResult, DeclaredDeviationsNeedNotBeRight)
{
  RandomStream random(4);
  CalibrationProblem problem = recordedDrive(erroneous(), random);
  for (CalibrationReading& r : problem.readings) r.std *= r.is_range ? 4 : 0.3;
  for (TrajectoryPose& pose : problem.poses)
    if (pose.since_previous)
      for (Matrix3d& noise : *pose.since_previous) noise *= 9;
  const CalibrationResult found = calibrate(problem, kAll);
  ASSERT_EQ(found.status, SolveStatus::ok);
  EXPECT_NEAR(found.scatter[0].range, 0.25, 0.05);
  EXPECT_NEAR(found.scatter[0].bearing, 3.3, 0.7);
  for (const MotionNoise noise : {position_noise, heading_noise})
    EXPECT_NEAR(found.odometry_scatter[noise], 0.33, 0.12);  // ranges are used as declared, four times too inaccurate
  for (const ParameterEstimate& error : found.errors)
    EXPECT_LT(std::abs(error.value - trueValue(erroneous(), error.unknown.parameter)), 4 * error.std);
}

TEST(CalibrationResult, LeverArmsAndDriftAreToldFromDelayAndVeerByRests)
{
  DrivePlan plan = erroneous();
  plan.rests = true;
  plan.lever_arm = {0.06, -0.04};
  plan.drift = degToRad(0.3);
  std::vector<CalibrationUnknown> unknowns = kAll;
  for (const Kind kind : {Kind::lever_arm_x, Kind::lever_arm_y, Kind::drift}) unknowns.push_back({kind});
  const double consistency = meanSquareOverVariance(plan, unknowns, testing::runsOfTest(6));
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_GT(consistency, 0.4);
  EXPECT_LT(consistency, 1.6);
}

TEST(CalibrationResult, AtOneSpeedALeverArmIsADelayAndADriftAVeer)
{
  DrivePlan plan;
  plan.evenly = true;
  plan.std_distance_per_root_s = plan.std_turn_per_root_s = 0.001;
  plan.lever_arm = {0.06, 0};
  plan.drift = degToRad(0.3);
  RandomStream random(10);
  const CalibrationResult found =
      calibrate(recordedDrive(plan, random),
                {{Kind::delay}, {Kind::lever_arm_x}, {Kind::bearing_offset}, {Kind::veer}, {Kind::drift}});
  ASSERT_EQ(found.status, SolveStatus::ok);
  for (const Kind kind : {Kind::lever_arm_x, Kind::veer, Kind::drift})
  {
    EXPECT_FALSE(errorOf(found, kind).observable) << static_cast<int>(kind) << " +- " << errorOf(found, kind).std;
    EXPECT_EQ(errorOf(found, kind).value, 0);
  }
  EXPECT_GT(errorOf(found, Kind::delay).std, 0.8 * 0.05 / 0.4);  // 5 cm at 0.4 m/s
  EXPECT_FALSE(errorOf(found, Kind::delay).observable);
}

TEST(CalibrationResult, NoiseOfOdometryDoesNotMakeTheWayLongWhereReadingsAreLate)
{
  DrivePlan plan;
  plan.delay = 0.3;
  plan.std_distance_per_root_s = plan.std_turn_per_root_s = 0.06;
  double distance = 0, rotation = 0;
  const int runs = testing::runsOfTest(4);
  for (int seed = 1; seed <= runs; ++seed)
  {
    RandomStream random(static_cast<std::uint64_t>(seed), 11);
    const CalibrationResult found = calibrate(recordedDrive(plan, random), kAll);
    distance += errorOf(found, Kind::distance_scale).value / runs;
    rotation += errorOf(found, Kind::rotation_scale).value / runs;
  }
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_NEAR(distance, 0, 0.012);
  EXPECT_NEAR(rotation, 0, 0.025);
}

TEST(CalibrationResult, ScattersOfReadingsAndOdometryAreNotBiased)
{
  double range = 0;
  double odometry = 0;  // the scatter of both noises together
  const int runs = testing::runsOfTest(30);
  for (int seed = 1; seed <= runs; ++seed)
  {
    RandomStream random(static_cast<std::uint64_t>(seed), 12);
    const CalibrationResult found = calibrate(recordedDrive({}, random), kAll);
    range += found.scatter[0].range / runs;
    const auto& [position, heading] = found.odometry_redundancy;
    EXPECT_GT(position + heading, 100);
    odometry += std::sqrt((position * square(found.odometry_scatter[position_noise]) +
                           heading * square(found.odometry_scatter[heading_noise])) /
                          (position + heading)) /
                runs;
    EXPECT_LT(found.odometry_scatter_std[heading_noise], 0.2) << seed;
    EXPECT_LT(found.odometry_scatter_std[position_noise], 0.25) << seed;
    for (const MotionNoise noise : {position_noise, heading_noise})
      EXPECT_NEAR(found.odometry_scatter[noise], 1, 4 * found.odometry_scatter_std[noise]) << seed;
    EXPECT_GT(found.scatter[0].range_redundancy, 0.5 * static_cast<double>(found.scatter[0].ranges));
  }
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_NEAR(range, 1, 0.02);
  EXPECT_NEAR(odometry, 1, 0.05);
}

// Wheels slip, the gyro is good.
TEST(CalibrationResult, NoiseOfThePositionIsToldFromThatOfTheHeading)
{
  for (const MotionNoise wrong : {position_noise, heading_noise})
  {
    RandomStream random(21, wrong);
    DrivePlan plan;
    CalibrationProblem problem = recordedDrive(plan, random);
    for (TrajectoryPose& pose : problem.poses)
      if (pose.since_previous) (*pose.since_previous)[wrong] /= 25;
    const CalibrationResult found = calibrate(problem, kAll);
    ASSERT_EQ(found.status, SolveStatus::ok);
    for (const MotionNoise noise : {position_noise, heading_noise})
    {
      const double truth = noise == wrong ? 5 : 1, std = found.odometry_scatter_std[noise];
      EXPECT_NEAR(found.odometry_scatter[noise], truth, 4 * std) << wrong << noise;
      EXPECT_LT(std, 0.25 * truth);
    }
  }
}

TEST(CalibrationResult, MisfitsShowTheOutliers)
{
  DrivePlan plan = erroneous();
  plan.outliers = 0.1;
  RandomStream random(5);
  const CalibrationResult found = calibrate(recordedDrive(plan, random), kAll);
  double outliers = 0;
  for (const double misfit : found.misfits) outliers += std::abs(misfit) > 4;
  EXPECT_NEAR(outliers / static_cast<double>(found.misfits.size()), 0.1, 0.02);
}

TEST(CalibrationResult, ARobotThatStandsTellsNothingOfItsOdometry)
{
  DrivePlan plan = erroneous();
  plan.speed = plan.weave = 0;
  RandomStream random(6);
  const CalibrationResult found = calibrate(recordedDrive(plan, random), kAll);
  ASSERT_EQ(found.status, SolveStatus::ok);
  for (const Kind kind : {Kind::delay, Kind::distance_scale, Kind::rotation_scale, Kind::veer, Kind::bearing_offset})
  {
    EXPECT_FALSE(errorOf(found, kind).observable) << static_cast<int>(kind);
    EXPECT_EQ(errorOf(found, kind).value, 0);
    EXPECT_TRUE(std::isfinite(errorOf(found, kind).std));
  }
  EXPECT_TRUE(errorOf(found, Kind::range_offset).observable);
}

TEST(CalibrationResult, BearingsToOneLandmarkHaveNoScale)
{
  DrivePlan plan = erroneous();
  plan.landmarks = {{1, 6}};
  plan.landmarks_seen = 1;
  plan.ranges = false;
  RandomStream random(8);
  const CalibrationResult found =
      calibrate(recordedDrive(plan, random), {{Kind::distance_scale}, {Kind::veer}, {Kind::rotation_scale}});
  ASSERT_EQ(found.status, SolveStatus::ok);
  EXPECT_FALSE(errorOf(found, Kind::distance_scale).observable);
}

TEST(CalibrationResult, BadOrLittleInputIsAStatus)
{
  RandomStream random(9);
  EXPECT_EQ(calibrate({}, {}).status, SolveStatus::too_few);
  CalibrationProblem problem = recordedDrive({}, random);
  problem.readings[4].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(calibrate(problem, kAll).status, SolveStatus::bad_input);
  problem.readings.resize(3);
  EXPECT_EQ(calibrate(problem, kAll).status, SolveStatus::too_few);
  EXPECT_EQ(calibrate(problem, {{Kind::delay, 3}}).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext::test_self_calibration
