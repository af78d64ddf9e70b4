#include "mrpt_ext/diagnosis/innovation_regression.h"

#include <gtest/gtest.h>

#include "recorded_drive.h"

namespace mrpt_ext::test_innovation_regression
{
namespace
{
using testing::DrivePlan;
using Kind = CalibrationParameter;

const std::vector<CalibrationUnknown> kAll{{Kind::distance_scale}, {Kind::rotation_scale}, {Kind::veer},
                                           {Kind::bearing_offset}, {Kind::range_offset},   {Kind::range_scale},
                                           {Kind::range_height},   {Kind::drift}};

DrivePlan quietDrive()
{
  DrivePlan plan;
  plan.outliers = 0;
  plan.duration = 200;
  return plan;
}

MotionModel motionOf(const DrivePlan& plan)
{
  return {.std_xy_per_m = 0.001,
          .std_phi_per_deg = 0.01,
          .std_phi_per_m = 0.001,
          .std_xy_per_s = plan.std_distance_per_root_s,
          .std_phi_per_s = plan.std_turn_per_root_s};
}

ScalarMeasurement measured(const CalibrationReading& r, const BiasFreeFilter& filter)
{
  const Pose2& pose = filter.pose().mean;
  const JacobianRow row = r.is_range ? rangeJacobian(pose, r.landmark) : bearingJacobian(pose, r.landmark);
  const double predicted = r.is_range ? predictRange(pose, r.landmark) : predictBearing(pose, r.landmark);
  Eigen::RowVectorXd unknown = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(kAll.size()));
  unknown[3] = r.is_range ? 0 : 1;
  unknown[4] = r.is_range ? 1 : 0;
  unknown[5] = r.is_range ? predicted : 0;
  unknown[6] = r.is_range ? 0.5 / predicted : 0;
  return {r.is_range ? r.value - predicted : wrap(r.value - predicted), r.std, row, unknown};
}

std::vector<RegressedError> errorsFound(const DrivePlan& plan, std::uint64_t seed)
{
  RandomStream random(seed);
  const CalibrationProblem problem = testing::recordedDrive(plan, random);
  const OdometryPath odometry(problem.odometry, {});
  BiasFreeFilter filter(kAll, motionOf(plan));
  InnovationRegression regression(kAll, 0);
  filter.start({driveAt(plan, 0), Matrix3d::Identity() * 0.01});
  std::size_t next = 0;
  for (std::size_t k = 0; k < problem.poses.size(); ++k)
  {
    if (k > 0) filter.predict(odometry.between(problem.poses[k - 1].time, problem.poses[k].time));
    for (; next < problem.readings.size() && problem.readings[next].pose == k; ++next)
    {
      const ScalarMeasurement measurement = measured(problem.readings[next], filter);
      regression.add(filter.innovation(measurement));
      filter.update(measurement);
    }
    regression.endFrame(filter);
  }
  return regression.significantErrors();
}

const RegressedError* find(const std::vector<RegressedError>& errors, Kind kind)
{
  for (const RegressedError& error : errors)
    if (error.unknown.parameter == kind) return &error;
  return nullptr;
}

void expectFound(const DrivePlan& plan, Kind kind, double value)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const std::vector<RegressedError> errors = errorsFound(plan, seed);
    const RegressedError* error = find(errors, kind);
    ASSERT_NE(error, nullptr) << seed;
    EXPECT_NEAR(error->value, value, 5 * error->std + 0.1 * std::abs(value)) << seed;
    EXPECT_GT(error->effect, 0.5) << seed;
  }
}
}  // namespace

TEST(InnovationRegression, FindsAnOffsetOfTheBearings)
{
  DrivePlan plan = quietDrive();
  plan.bearing_offset = degToRad(2.0);
  expectFound(plan, Kind::bearing_offset, degToRad(2.0));
}

TEST(InnovationRegression, FindsAScaleOfTheRanges)
{
  DrivePlan plan = quietDrive();
  plan.range_scale = 0.04;
  expectFound(plan, Kind::range_scale, 0.04);
}

TEST(InnovationRegression, FindsAScaleOfOdometry)
{
  DrivePlan plan = quietDrive();
  plan.distance_scale = 0.1;
  expectFound(plan, Kind::distance_scale, 0.1);
}

TEST(InnovationRegression, FindsADriftOfTheHeading)
{
  DrivePlan plan = quietDrive();
  plan.drift = 0.02;
  plan.rests = true;  // tell it from a veer
  expectFound(plan, Kind::drift, 0.02);
}

TEST(InnovationRegression, TellsAHeightFromAnOffset)
{
  DrivePlan plan = quietDrive();
  plan.height = 1;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const std::vector<RegressedError> errors = errorsFound(plan, seed);
    ASSERT_FALSE(errors.empty()) << seed;
    EXPECT_EQ(errors.front().unknown.parameter, Kind::range_height) << seed;
    EXPECT_NEAR(errors.front().value, 1, 0.3) << seed;
  }
  plan.height = 0;
  plan.range_offset = 0.2;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    EXPECT_EQ(find(errorsFound(plan, seed), Kind::range_height), nullptr) << seed;
}

TEST(InnovationRegression, ACleanRecordingHasNone)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_TRUE(errorsFound(quietDrive(), seed).empty()) << seed;
}

TEST(InnovationRegression, ANuisanceIsNotReported)
{
  InnovationRegression regression({{Kind::range_offset}}, 1);
  BiasFreeFilter filter({{Kind::range_offset}}, MotionModel{});
  filter.start({{}, Matrix3d::Identity()});
  for (int k = 0; k < 100; ++k)
  {
    regression.add({1.0, 1.0, Eigen::RowVectorXd::Ones(1)});
    regression.endFrame(filter);
  }
  EXPECT_TRUE(regression.significantErrors().empty());
}
}  // namespace mrpt_ext::test_innovation_regression
