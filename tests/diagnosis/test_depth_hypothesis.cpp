#include "mrpt_ext/diagnosis/depth_hypothesis.h"

#include <gtest/gtest.h>

#include "recorded_drive.h"

namespace mrpt_ext::test_depth_hypothesis
{
namespace
{
using testing::DrivePlan;
using Kind = CalibrationParameter;

/// A camera that sees 70 degrees, with errors of its own that nobody stated.
DrivePlan camera()
{
  DrivePlan plan;
  plan.duration = 240;
  plan.landmarks_seen = 5;
  plan.field_of_view = degToRad(70.0);
  plan.outliers = 0;
  plan.range_scale = -0.05;
  plan.range_offset = 0.05;
  plan.delay = 0.1;
  return plan;
}

CalibrationProblem recorded(const DrivePlan& plan)
{
  RandomStream random(1, 4);
  return testing::recordedDrive(plan, random);
}

std::vector<DepthHypothesis> chosen(CalibrationProblem& problem, bool configured)
{
  const std::vector<CalibrationUnknown> unknowns{
      {Kind::distance_scale}, {Kind::delay}, {Kind::range_offset}, {Kind::range_scale}};
  return chooseDepths(problem, {configured}, unknowns, {.sensors = {{}}});
}

/// Largest difference of the readings of two recordings, [rad] or [m].
double difference(const CalibrationProblem& a, const CalibrationProblem& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.readings.size(); ++i)
    largest = std::max(largest, std::abs(a.readings[i].value - b.readings[i].value));
  return largest;
}
}  // namespace

TEST(DepthHypothesis, DepthsAreToldFromRangesAndConverted)
{
  DrivePlan plan = camera();
  plan.depths = true;
  const CalibrationProblem logged = recorded(plan);
  CalibrationProblem problem = logged;
  const std::vector<DepthHypothesis> depths = chosen(problem, false);
  ASSERT_EQ(depths.size(), 1U);
  EXPECT_FALSE(depths.front().configured);
  EXPECT_TRUE(depths.front().likelier);
  EXPECT_GT(depths.front().gain.gain, 3 * depths.front().gain.std);
  EXPECT_TRUE(depths.front().told);
  for (std::size_t i = 1; i < logged.readings.size(); i += 2)
    EXPECT_NEAR(problem.readings[i].value, logged.readings[i].value / std::cos(logged.readings[i - 1].value), 1e-12);
}

TEST(DepthHypothesis, RangesOfAWrongScaleAreNoDepths)
{
  const CalibrationProblem logged = recorded(camera());
  CalibrationProblem problem = logged;
  const std::vector<DepthHypothesis> depths = chosen(problem, false);
  ASSERT_EQ(depths.size(), 1U);
  EXPECT_FALSE(depths.front().likelier);
  EXPECT_TRUE(depths.front().told);
  EXPECT_LT(depths.front().gain.gain, -3 * depths.front().gain.std);
  EXPECT_EQ(difference(problem, logged), 0);
}

TEST(DepthHypothesis, RangesThatAreConfiguredAsDepthsAreToldToo)
{
  CalibrationProblem problem = recorded(camera());
  for (std::size_t i = 1; i < problem.readings.size(); i += 2)
    problem.readings[i].value /= std::cos(*problem.readings[i].off_axis);
  const std::vector<DepthHypothesis> depths = chosen(problem, true);
  ASSERT_EQ(depths.size(), 1U);
  EXPECT_TRUE(depths.front().configured);
  EXPECT_FALSE(depths.front().likelier);
  EXPECT_LT(difference(problem, recorded(camera())), 1e-9);
}

TEST(DepthHypothesis, IsNoQuestionForASensorThatSeesToTheSide)
{
  DrivePlan plan = camera();
  plan.field_of_view = 10;
  CalibrationProblem problem = recorded(plan);
  EXPECT_TRUE(chosen(problem, false).empty());
  plan = camera();
  plan.bearings = false;
  problem = recorded(plan);
  EXPECT_TRUE(chosen(problem, false).empty());
}

TEST(DepthHypothesis, TooFewReadingsTellNothing)
{
  DrivePlan plan = camera();
  plan.duration = 5;
  CalibrationProblem problem = recorded(plan);
  const std::vector<DepthHypothesis> depths = chosen(problem, false);
  ASSERT_EQ(depths.size(), 1U);
  EXPECT_FALSE(depths.front().likelier);
  EXPECT_FALSE(depths.front().told);
}
}  // namespace mrpt_ext::test_depth_hypothesis
