#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/calibration/self_calibration.h"
#include "recorded_drive.h"
#include "test_length.h"

namespace mrpt_ext::test_errors_of_landmarks
{
namespace
{
using testing::DrivePlan;
using testing::recordedDrive;
using Kind = CalibrationParameter;

const ParameterEstimate& errorOf(const CalibrationResult& found, Kind kind)
{
  for (const ParameterEstimate& error : found.errors)
    if (error.unknown.parameter == kind) return error;
  throw std::logic_error("not asked for");
}

/// Offset and scale of ranges, and the offsets of all landmarks.
std::vector<CalibrationUnknown> withLandmarkOffsets(const DrivePlan& plan)
{
  std::vector<CalibrationUnknown> unknowns{{Kind::range_offset}, {Kind::range_scale}};
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i) unknowns.push_back({Kind::landmark_offset, 0, i});
  return unknowns;
}
}  // namespace

TEST(ErrorsOfLandmarks, OffsetsOfLandmarksAreFound)
{
  DrivePlan plan;
  plan.bearings = false;
  plan.landmark_offsets = {0.1, -0.15, 0, 0.2, -0.05};
  std::vector<CalibrationUnknown> unknowns;
  for (std::size_t i = 0; i < plan.landmarks.size(); ++i) unknowns.push_back({Kind::landmark_offset, 0, i});
  RandomStream random(8);
  const CalibrationResult found = calibrate(recordedDrive(plan, random), unknowns);
  ASSERT_EQ(found.status, SolveStatus::ok);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
  {
    EXPECT_TRUE(found.errors[i].observable);
    EXPECT_NEAR(found.errors[i].value, plan.landmark_offsets[i], 4 * found.errors[i].std);
    EXPECT_LT(found.errors[i].std, 0.02);
  }
  EXPECT_NEAR(found.scatter[0].landmark_offset_std, 0.12, 0.03);
}

TEST(ErrorsOfLandmarks, PlacesOfLandmarksAreFound)
{
  const Vector2d shift(-0.3, 0.25);
  for (const bool bearings : {false, true})
  {
    DrivePlan plan;
    plan.bearings = bearings;
    plan.ranges = !bearings;
    RandomStream random(11);
    CalibrationProblem problem = recordedDrive(plan, random);
    for (CalibrationReading& r : problem.readings)
      if (r.landmark_number == 2) r.landmark -= shift;
    const std::vector<CalibrationUnknown> unknowns{{Kind::landmark_x, 0, 2}, {Kind::landmark_y, 0, 2}};
    const CalibrationResult found = calibrate(problem, unknowns);
    ASSERT_EQ(found.status, SolveStatus::ok);
    for (Eigen::Index axis = 0; axis < 2; ++axis)
    {
      const ParameterEstimate& error = found.errors[static_cast<std::size_t>(axis)];
      EXPECT_TRUE(error.observable);
      EXPECT_NEAR(error.value, shift[axis], 3 * error.std);
      EXPECT_LT(error.std, 0.05);
    }
    EXPECT_NEAR(found.scatter[0].landmark_place_std, std::sqrt(shift.squaredNorm() / 2), 0.05);
    EXPECT_EQ(found.scatter[0].landmark_offset_std, 0);
  }
}

TEST(ErrorsOfLandmarks, LandmarksThatAreOutOfSightForAWhileKeepTheirOffsets)
{
  const int drives = testing::runsOfTest(8);
  double in_deviations = 0, squares = 0;
  for (int seed = 1; seed <= drives; ++seed)
  {
    RandomStream random(static_cast<std::uint64_t>(seed), 22);
    DrivePlan plan;
    plan.duration = 240;
    plan.outliers = 0;
    plan.hidden = 0.4;
    for (std::size_t i = 0; i < plan.landmarks.size(); ++i) plan.landmark_offsets.push_back(0.05 * random.gaussian());
    std::vector<CalibrationUnknown> unknowns{{Kind::distance_scale}, {Kind::delay}};
    for (std::size_t i = 0; i < plan.landmarks.size(); ++i) unknowns.push_back({Kind::landmark_offset, 0, i});
    const CalibrationResult found = calibrate(recordedDrive(plan, random), unknowns);
    ASSERT_EQ(found.status, SolveStatus::ok);
    for (std::size_t i = 0; i < plan.landmarks.size(); ++i)
    {
      const ParameterEstimate& error = found.errors[2 + i];
      in_deviations += square((error.value - plan.landmark_offsets[i]) / error.std);
      squares += square(error.value - plan.landmark_offsets[i]);
    }
  }
  const auto count = static_cast<double>(5 * drives);
  EXPECT_LT(std::sqrt(squares / count), 0.004);
  EXPECT_LT(in_deviations / count, 1.5);
}

TEST(ErrorsOfLandmarks, LandmarksThatDisagreeHardlyTellWhatTheyShare)
{
  const int drives = testing::runsOfTest(12);
  double sum = 0;
  for (int seed = 1; seed <= drives; ++seed)
  {
    RandomStream random(static_cast<std::uint64_t>(seed), 21);
    DrivePlan plan;
    plan.bearings = false;
    for (std::size_t i = 0; i < plan.landmarks.size(); ++i) plan.landmark_offsets.push_back(0.1 * random.gaussian());
    const CalibrationResult found = calibrate(recordedDrive(plan, random), withLandmarkOffsets(plan));
    ASSERT_EQ(found.status, SolveStatus::ok);
    for (const Kind kind : {Kind::range_offset, Kind::range_scale})
      sum += square(errorOf(found, kind).value / errorOf(found, kind).std);
  }
  if (testing::isShort()) return;  // too few runs for the bounds
  EXPECT_LT(sum / (2 * drives), 2);
  EXPECT_GT(sum / (2 * drives), 0.2);
}

TEST(ErrorsOfLandmarks, LandmarksThatAgreeTellWhatTheyShare)
{
  RandomStream random(9);
  DrivePlan plan;
  plan.bearings = false;
  plan.range_offset = 0.2;
  const CalibrationResult found = calibrate(recordedDrive(plan, random), withLandmarkOffsets(plan));
  ASSERT_EQ(found.status, SolveStatus::ok);
  const ParameterEstimate& offset = errorOf(found, Kind::range_offset);
  EXPECT_NEAR(offset.value, 0.2, 4 * offset.std);
  EXPECT_LT(offset.std, 0.03);
  EXPECT_LT(found.scatter[0].landmark_offset_std, 0.02);
}
}  // namespace mrpt_ext::test_errors_of_landmarks
