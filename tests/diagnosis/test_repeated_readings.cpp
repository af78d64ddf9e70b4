#include "mrpt_ext/diagnosis/repeated_readings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/calibration/self_calibration.h"
#include "recorded_drive.h"

namespace mrpt_ext::test_repeated_readings
{
namespace
{
using testing::DrivePlan;
using Kind = CalibrationParameter;

const std::vector<CalibrationUnknown> kUnknowns{{Kind::distance_scale}, {Kind::range_offset}};

/// Ranges ten times a second; their errors have a standard deviation of 0.2 m and last for some seconds.
CalibrationData radios(DrivePlan plan, std::uint64_t seed, double lasting = 0.2, double duration = 200)
{
  plan.duration = duration;
  plan.rate = 10;
  plan.landmarks_seen = 5;
  RandomStream random(seed, 5);
  CalibrationData data{.problem = testing::recordedDrive(plan, random), .sensors = {"uwb"}, .identified = {true}};
  const double kept = std::exp(-0.1 / 4);
  std::vector<double> errors(plan.landmarks.size());
  for (double& error : errors) error = lasting * random.gaussian();
  for (CalibrationReading& r : data.problem.readings)
  {
    if (!r.is_range) continue;
    double& error = errors[r.landmark_number];
    error = kept * error + lasting * std::sqrt(1 - kept * kept) * random.gaussian();
    r.value += error;
  }
  return data;
}

DrivePlan rangesOnly()
{
  DrivePlan plan;
  plan.bearings = false;
  plan.outliers = 0.01;
  return plan;
}
}  // namespace

TEST(LeaveOutRepeated, ErrorsOfRadiosThatLastAreNotTakenForThoseOfOdometry)
{
  double misled = 0, told = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed)
  {
    CalibrationData data = radios(rangesOnly(), seed);
    const std::size_t all = data.problem.readings.size();
    misled += calibrate(data.problem, kUnknowns).odometry_scatter[position_noise] / 2;
    leaveOutRepeated(data, kUnknowns);
    EXPECT_EQ(data.problem.readings.size() + data.repeated, all);
    EXPECT_LT(data.problem.readings.size(), all / 5);
    EXPECT_GT((data.correlation_times[{0, true}]), 0.7);
    const CalibrationResult found = calibrate(data.problem, kUnknowns);
    ASSERT_EQ(found.status, SolveStatus::ok);
    told += found.odometry_scatter[position_noise] / 2;
    EXPECT_LT(std::abs(found.errors[0].value), 3 * found.errors[0].std) << "distance";
    EXPECT_LT(std::abs(found.errors[1].value), 3 * found.errors[1].std) << "offset";
  }
  EXPECT_GT(misled, 3) << "times the noise that odometry has";
  EXPECT_LT(told, 0.6 * misled);
}

TEST(LeaveOutRepeated, WhiteErrorsBearingsAndOdometryThatIsMissingChangeNothing)
{
  CalibrationData white = radios(rangesOnly(), 1, 0), with_bearings = radios({}, 1), alone = radios(rangesOnly(), 1);
  alone.problem.odometry.clear();
  for (CalibrationData* data : {&white, &with_bearings, &alone})
  {
    const std::size_t all = data->problem.readings.size();
    leaveOutRepeated(*data, kUnknowns);
    EXPECT_EQ(data->problem.readings.size(), all);
    EXPECT_EQ(data->repeated, 0u);
  }
}

// Without offsets of the landmarks among the unknowns such errors last for ever.
TEST(LeaveOutRepeated, AsManyStayAsACalibrationOfEachHalfNeeds)
{
  for (const double duration : {8.0, 60.0})
  {
    DrivePlan plan = rangesOnly();
    plan.landmark_offsets = {0.6, -0.5, 0.7, -0.6, 0.5};
    CalibrationData data = radios(plan, 3, 0, duration);
    std::vector<CalibrationUnknown> many = kUnknowns;
    for (std::size_t k = 0; k < 5; ++k)
      for (const Kind kind : {Kind::landmark_x, Kind::landmark_y}) many.push_back({kind, 0, k});
    CalibrationData other = data;
    leaveOutRepeated(data, kUnknowns);
    EXPECT_GT(data.repeated, 0u);
    EXPECT_GE(data.problem.readings.size(), 40u);
    EXPECT_EQ(calibrate(data.problem, kUnknowns).status, SolveStatus::ok);
    leaveOutRepeated(other, many);
    EXPECT_GE(other.problem.readings.size(), 6 * many.size());
  }
}

TEST(LeaveOutRepeated, TheShareOfReadingsWithoutALandmarkStays)
{
  CalibrationData data = radios(rangesOnly(), 2);
  for (std::size_t k = 0; k < 1000; ++k) data.unmatched.push_back({2 * k, 0, true});
  const double before = 1000 / static_cast<double>(data.problem.readings.size());
  leaveOutRepeated(data, kUnknowns);
  ASSERT_GT(data.repeated, 0u);
  EXPECT_NEAR(static_cast<double>(data.unmatched.size()) / static_cast<double>(data.problem.readings.size()), before,
              0.02 * before);
}
}  // namespace mrpt_ext::test_repeated_readings
