#include "mrpt_ext/calibration/predictive_likelihood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "recorded_drive.h"

namespace mrpt_ext::test_predictive_likelihood
{
namespace
{
using Kind = CalibrationParameter;

CalibrationProblem driven(const testing::DrivePlan& plan, std::uint64_t seed)
{
  RandomStream random(seed, 3);
  return testing::recordedDrive(plan, random);
}

RecordingModel model(std::vector<AssumedError> errors = {}, AssumedNoise noise = {})
{
  return {.errors = std::move(errors), .sensors = {noise}};
}

PredictiveGain gainOf(const CalibrationProblem& problem, const RecordingModel& better, const RecordingModel& worse)
{
  return predictiveGain(problem, problem.poses.size() / 2, predictiveLogDensities(problem, better),
                        predictiveLogDensities(problem, worse));
}

bool isSignificant(const PredictiveGain& gain) { return gain.gain > 3 * gain.std; }
}  // namespace

TEST(PredictiveLikelihood, ErrorsThatAreThereImproveThePrediction)
{
  const testing::DrivePlan plan{
      .delay = 0.1, .bearing_offset = 0.02, .range_scale = 0.05, .distance_scale = 0.06, .veer = 0.05};
  const CalibrationProblem problem = driven(plan, 1);
  const std::vector<AssumedError> all{{{Kind::delay}, plan.delay},
                                      {{Kind::bearing_offset}, plan.bearing_offset},
                                      {{Kind::range_scale}, plan.range_scale},
                                      {{Kind::distance_scale}, plan.distance_scale},
                                      {{Kind::veer}, plan.veer}};
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    std::vector<AssumedError> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const PredictiveGain gain = gainOf(problem, model(all), model(others));
    EXPECT_TRUE(isSignificant(gain)) << k << ": " << gain.gain << " +- " << gain.std;
  }
}

TEST(PredictiveLikelihood, AnOffsetOfBearingsPaysWhereTheHeadingsTookItUp)
{
  for (const double offset : {-2.6, 1.0, 3.1})
  {
    CalibrationProblem problem = driven({.bearing_offset = offset}, 6);
    for (TrajectoryPose& pose : problem.poses) pose.pose.phi = wrap(pose.pose.phi - offset);
    EXPECT_TRUE(isSignificant(gainOf(problem, model({{{Kind::bearing_offset}, offset}}), model()))) << offset;
  }
}

TEST(PredictiveLikelihood, ErrorsThatAreNotThereDoNotPay)
{
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
  {
    const CalibrationProblem problem = driven({}, seed);
    EXPECT_LT(gainOf(problem, model({{{Kind::delay}, 0.05}}), model()).gain, 0);
    EXPECT_LT(gainOf(problem, model({{{Kind::distance_scale}, 0.05}}), model()).gain, 0);
    EXPECT_LT(gainOf(problem, model({{{Kind::bearing_offset}, 0.02}}), model()).gain, 0);
  }
}

TEST(PredictiveLikelihood, RightDeviationsPredictBest)
{
  const CalibrationProblem problem = driven({}, 2);
  for (const double factor : {0.6, 1.7})
  {
    EXPECT_TRUE(isSignificant(gainOf(problem, model(), model({}, {.bearing = factor}))));
    EXPECT_TRUE(isSignificant(gainOf(problem, model(), model({}, {.range = factor}))));
    RecordingModel odometry = model();
    odometry.odometry = {factor * factor, factor * factor};
    EXPECT_TRUE(isSignificant(gainOf(problem, model(), odometry))) << factor;
    for (const MotionNoise noise : {position_noise, heading_noise})
    {
      RecordingModel one = model();
      one.odometry[noise] = factor * factor;
      EXPECT_GT(gainOf(problem, model(), one).gain, 0) << factor << " of " << noise;
    }
  }
  EXPECT_GT(gainOf(problem, model({}, {.outliers = 0.03}), model({}, {.outliers = 0.3})).gain, 0);
}

TEST(PredictiveLikelihood, AnErrorThatTheFilterEstimatesNeedsNoCalibration)
{
  const CalibrationProblem problem = driven({.range_scale = 0.05}, 3);
  const PredictiveGain gain =
      gainOf(problem, model({{{Kind::range_scale}, 0.05}}), model({{{Kind::range_scale}, 0, 0.1}}));
  EXPECT_LT(std::abs(gain.gain), 5);
}

TEST(PredictiveLikelihood, StaysFiniteWhereTheRobotWasCarried)
{
  CalibrationProblem problem = driven({}, 4);
  for (TrajectoryPose& pose : problem.poses)
    if (pose.time > 60) pose.pose.x += 50;  // and all readings from there on are outliers
  for (const double density : predictiveLogDensities(problem, model())) EXPECT_TRUE(std::isfinite(density));
}

TEST(PredictiveLikelihood, FewPosesTellNothing)
{
  CalibrationProblem problem = driven({.duration = 1}, 5);
  EXPECT_TRUE(std::isinf(gainOf(problem, model(), model()).std));
}
}  // namespace mrpt_ext::test_predictive_likelihood
