#include "mrpt_ext/evaluation/scoring.h"

#include <gtest/gtest.h>

#include "hand_made_runs.h"

namespace mrpt_ext::test_scoring
{
using namespace testing;

namespace
{
double noError(double) { return 0; }

std::vector<double> stampsOf(const std::vector<JudgedEstimate>& judged)
{
  std::vector<double> stamps;
  for (const auto& entry : judged) stamps.push_back(entry.stamp - kLogStart);
  return stamps;
}
}  // namespace

TEST(ScoringStamps, AreTheFullSecondsWithinTheLog)
{
  RunContext context = straightRun(3.7);
  context.start_time += 0.3;
  context.duration_s = 3.0;  // 0.3 .. 3.3
  EXPECT_EQ(scoringStamps(context), (std::vector<double>{1001, 1002, 1003}));
}

TEST(ScoringStamps, LeaveOutLongGapsOfTheTruth)
{
  RunContext context = straightRun(10);
  std::erase_if(context.truth, [](const TimedPose& p) { return p.time > 1003.75 && p.time < 1006.25; });
  EXPECT_EQ(scoringStamps(context), (std::vector<double>{1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010}));
  std::erase_if(context.truth, [](const TimedPose& p) { return p.time > 1007.85 && p.time < 1008.15; });
  EXPECT_EQ(scoringStamps(context).size(), 8u);  // a gap of 0.4 s is interpolated
}

TEST(ScoringStamps, OfSparseTruthAreItsOwn)
{
  RunContext context = straightRun(10);
  context.truth_is_sparse = true;
  context.truth = {{999, {}, true}, {1002.25, {}, true}, {1007.5, {}, true}, {1011, {}, true}};
  EXPECT_EQ(scoringStamps(context), (std::vector<double>{1002.25, 1007.5}));
}

TEST(ScoringStamps, NeedTruth)
{
  RunContext context = straightRun(10);
  context.truth.clear();
  EXPECT_TRUE(scoringStamps(context).empty());
}

TEST(Judge, ContinuousEstimatesArePredictedByDeadReckoning)
{
  const RunContext context = straightRun(4);
  // One estimate only, at 1.5 s and 0.2 m to the side: predicted by the odometry.
  const RunRecord record = recordOf({trackWithError("f", 1.5, 1.5, 1, [](double) { return 0.2; })});
  const auto judged = judge(record.methods[0], context);
  EXPECT_EQ(stampsOf(judged), (std::vector<double>{2, 3, 4}));  // nothing before the first estimate
  for (const ErrorSample& error : errorsOf(judged))
  {
    EXPECT_NEAR(error.position_m, 0.2, 1e-9);
    EXPECT_NEAR(*error.heading_deg, 0, 1e-9);
  }
}

TEST(Judge, WithoutOdometryAnOldEstimateFallsBehind)
{
  RunContext context = straightRun(4);
  context.odometry.clear();
  const auto errors = errorsOf(judge(trackWithError("f", 1, 1, 1, noError), context));
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_NEAR(errors.back().position_m, 3, 1e-9);
}

TEST(Judge, ClosedFormsAreJudgedAtTheirOwnTime)
{
  const RunContext context = straightRun(5);
  MethodTrajectory trajectory = trackWithError("closed", 0.4, 4.4, 2, noError);  // at 0.4, 2.4 and 4.4 s
  trajectory.continuous = false;
  const auto judged = judge(trajectory, context);
  EXPECT_EQ(stampsOf(judged), (std::vector<double>{1, 3, 5}));
  EXPECT_NEAR(judged[1].estimate.time, 1002.4, 1e-9);
  for (const ErrorSample& error : errorsOf(judged)) EXPECT_NEAR(error.position_m, 0, 1e-9);
}

TEST(Judge, TheLastEstimateOfASecondCounts)
{
  const RunContext context = straightRun(2);
  MethodTrajectory trajectory = trackWithError("closed", 0, 2, 0.25, [](double t) { return t; });
  trajectory.continuous = false;
  const auto errors = errorsOf(judge(trajectory, context));
  ASSERT_EQ(errors.size(), 3u);  // the estimate at exactly s belongs to the second that ends with s
  EXPECT_NEAR(errors[1].position_m, 1, 1e-9);
  EXPECT_NEAR(errors[2].position_m, 2, 1e-9);
}

TEST(Judge, SparseTruthTakesTheNearestEstimate)
{
  RunContext context = straightRun(10);
  context.truth_is_sparse = true;
  context.truth = {{1002.3, {2.3, 0, 0}, true}, {1006, {6, 0, 0}, true}};
  MethodTrajectory trajectory = trackWithError("closed", 2, 3, 0.4, noError);  // 2.0, 2.4, 2.8
  trajectory.continuous = false;
  const auto judged = judge(trajectory, context);
  ASSERT_EQ(judged.size(), 1u);  // nothing within 0.5 s of the second stamp
  EXPECT_NEAR(judged[0].estimate.pose.mean.x, 2.3, 1e-9);
}

TEST(Judge, ContinuousMethodsReachSparseStampsByDeadReckoning)
{
  RunContext context = straightRun(10);
  context.truth_is_sparse = true;
  context.truth = {{1006, {6, 0, 0}, true}};
  const auto errors = errorsOf(judge(trackWithError("f", 2, 2, 1, noError), context));
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NEAR(errors[0].position_m, 0, 1e-9);
}

TEST(ErrorsOf, HeadingOnlyWhereBothHaveIt)
{
  JudgedEstimate entry;
  entry.estimate.pose.mean.phi = degToRad(-179);
  entry.truth.pose.phi = degToRad(179);
  EXPECT_NEAR(*errorsOf({entry})[0].heading_deg, 2, 1e-9);
  entry.truth.heading_known = false;
  EXPECT_FALSE(errorsOf({entry})[0].heading_deg);
  entry.truth.heading_known = true;
  entry.estimate.heading_known = false;
  EXPECT_FALSE(errorsOf({entry})[0].heading_deg);
}
}  // namespace mrpt_ext::test_scoring
