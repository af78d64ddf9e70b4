#include "mrpt_ext/evaluation/run_scoring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_made_runs.h"

namespace mrpt_ext::test_run_scoring
{
using namespace testing;

namespace
{
const ConvergenceLimits kLimits;

/// 5 m off until it jumps to the true position 12 s into the log.
double jumpAtTwelve(double t) { return t < 11.99 ? 5.0 : 0.1; }

MethodTrajectory filterWithError(double duration, const std::function<double(double)>& error)
{
  return trackWithError("particle_filter", 0, duration, 0.5, error);
}

MethodTrajectory closedFormWithError(double duration, double error)
{
  MethodTrajectory trajectory = trackWithError("range_least_squares", 0.5, duration, 1, [=](double) { return error; });
  trajectory.continuous = false;
  return trajectory;
}
}  // namespace

TEST(RunScoring, TheJumpIsFoundAndSplitsTheErrors)
{
  const RunContext context = straightRun(40);
  const RunScore score =
      scoreRun(context, recordOf({filterWithError(40, jumpAtTwelve), closedFormWithError(39.5, 0.3)}), kLimits);
  EXPECT_EQ(score.judged_method, "particle_filter");
  EXPECT_NEAR(*score.converged_at_s, 12, 1e-9);
  EXPECT_EQ(score.trials.front().success, true);
  EXPECT_EQ(score.success_rate, 1.0);
  const MethodScore& filter = score.methods[0];
  EXPECT_EQ(filter.position_error_m.count, 29u);            // 12 .. 40
  EXPECT_EQ(filter.position_error_whole_run_m.count, 41u);  // 0 .. 40
  EXPECT_NEAR(*filter.position_error_m.rmse, 0.1, 1e-9);
  EXPECT_NEAR(*score.trials.front().rmse, 0.1, 1e-9);
  EXPECT_NEAR(*filter.position_error_whole_run_m.max, 5, 1e-9);
  EXPECT_NEAR(*filter.heading_error_deg.rmse, 0, 1e-9);
  EXPECT_EQ(score.methods[1].position_error_m.count, 29u);  // closed forms count from there on as well
  EXPECT_NEAR(*score.methods[1].position_error_m.rmse, 0.3, 1e-9);
}

TEST(RunScoring, OkAtAWrongPoseIsCounted)
{
  for (const Verdict verdict : {Verdict::ok, Verdict::ambiguous})
  {
    MethodTrajectory filter = filterWithError(40, jumpAtTwelve);
    MethodTrajectory judged = filter;
    judged.points.clear();
    for (PoseEstimate point : filter.points)
    {
      point.verdict = verdict;
      judged.points.push_back(point);
    }
    const RunScore score = scoreRun(straightRun(40), recordOf({judged}), kLimits);
    EXPECT_EQ(score.filter.ok_outside, verdict == Verdict::ok ? 24 : 0);
  }
}

TEST(RunScoring, NeverConvergedLeavesOnlyTheWholeRun)
{
  const RunScore score =
      scoreRun(straightRun(40), recordOf({filterWithError(40, [](double) { return 3.0; })}), kLimits);
  EXPECT_FALSE(score.converged_at_s);
  EXPECT_EQ(score.trials.front().success, false);
  EXPECT_EQ(score.success_rate, 0.0);
  EXPECT_FALSE(score.methods[0].position_error_m.rmse);
  EXPECT_FALSE(score.methods[0].heading_error_deg.rmse);
  EXPECT_NEAR(*score.methods[0].position_error_whole_run_m.rmse, 3, 1e-9);
  EXPECT_FALSE(score.filter.nees_mean);
}

TEST(RunScoring, ElevenSecondsLostAfterConvergenceIsAFailure)
{
  const auto lost = [](double t) { return t > 19.9 && t < 30.6 ? 2.0 : 0.1; };  // stamps 20 .. 30
  const RunScore score = scoreRun(straightRun(60), recordOf({filterWithError(60, lost)}), kLimits);
  EXPECT_NEAR(*score.converged_at_s, 0, 1e-9);
  EXPECT_EQ(score.trials.front().success, false);
}

TEST(RunScoring, WithoutTruthNoErrorExists)
{
  RunContext context = straightRun(40);
  context.truth.clear();
  const RunScore score = scoreRun(context, recordOf({filterWithError(40, jumpAtTwelve)}), kLimits);
  EXPECT_FALSE(score.trials.front().success);
  EXPECT_FALSE(score.success_rate);
  EXPECT_FALSE(score.methods[0].position_error_whole_run_m.rmse);
  EXPECT_EQ(score.methods[0].estimates, 81.0);
}

TEST(RunScoring, ClosedFormsAloneCountEverything)
{
  const RunScore score = scoreRun(straightRun(20), recordOf({closedFormWithError(19.5, 0.3)}), kLimits);
  EXPECT_FALSE(score.judged_method);
  EXPECT_FALSE(score.trials.front().success);
  EXPECT_NEAR(*score.methods[0].position_error_m.rmse, 0.3, 1e-9);
  EXPECT_EQ(score.methods[0].position_error_m.count, 20u);
  EXPECT_FALSE(score.filter.lost_steps);
}

TEST(RunScoring, OdometryIsAlignedAndNeverTheJudgedMethod)
{
  const MethodTrajectory odometry =
      movedBy({7, -3, 2.0}, trackWithError("odometry", 0, 20, 0.5, [](double) { return 0.0; }));
  const RunScore score = scoreRun(straightRun(20), recordOf({odometry}), kLimits);
  EXPECT_FALSE(score.judged_method);
  EXPECT_NEAR(*score.methods[0].position_error_m.rmse, 0, 1e-9);
}

TEST(RunScoring, AnotherContinuousMethodIsJudgedWithoutAFilter)
{
  MethodTrajectory ekf = filterWithError(40, jumpAtTwelve);
  ekf.name = "extended_kalman_filter";
  const RunScore score = scoreRun(straightRun(40), recordOf({ekf}), kLimits);
  EXPECT_EQ(score.judged_method, "extended_kalman_filter");
  EXPECT_NEAR(*score.converged_at_s, 12, 1e-9);
}

TEST(RunScoring, UnknownTruthHeadingIsNotJudged)
{
  RunContext context = straightRun(30);
  for (TimedPose& pose : context.truth) pose.heading_known = false;
  const MethodTrajectory filter = filterWithError(30, [](double) { return 0.1; });
  const RunScore score = scoreRun(context, recordOf({filter}), kLimits);
  EXPECT_FALSE(score.methods[0].heading_error_deg.rmse);
  EXPECT_EQ(score.trials.front().success, true);
  EXPECT_NEAR(*score.filter.nees_mean, 1,
              1e-9);  // 0.1 m off with a standard deviation of 0.1 m, two degrees of freedom
}

TEST(RunScoring, AvailabilityAndTimesComeFromTheTrajectory)
{
  MethodTrajectory trajectory = closedFormWithError(9.5, 0.1);
  trajectory.frames_offered = 20;
  trajectory.frames_answered = 5;
  trajectory.frames_ambiguous = 3;
  trajectory.step_milliseconds = {1, 2, 3, 4, 5};
  const MethodScore score = scoreRun(straightRun(10), recordOf({trajectory}), kLimits).methods[0];
  EXPECT_EQ(score.availability, 0.25);
  EXPECT_EQ(score.ambiguous, 3.0);
  EXPECT_EQ(score.step_ms_median, 3.0);
  EXPECT_NEAR(*score.step_ms_p95, 4.8, 1e-12);
}

TEST(RunScoring, NumbersOfAnEmptyTrajectoryDoNotExist)
{
  MethodTrajectory trajectory;
  trajectory.name = "running_fix";
  const MethodScore score = scoreRun(straightRun(10), recordOf({trajectory}), kLimits).methods[0];
  EXPECT_EQ(score.estimates, 0.0);
  EXPECT_FALSE(score.availability);
  EXPECT_FALSE(score.step_ms_median);
  EXPECT_FALSE(score.position_error_whole_run_m.rmse);
}
}  // namespace mrpt_ext::test_run_scoring
