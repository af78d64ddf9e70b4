#include "mrpt_ext/experiment/run_verdict.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_run_verdict
{
namespace
{
/// One verdict per second.
RunRecord runOf(const std::vector<Verdict>& verdicts)
{
  RunRecord run;
  MethodTrajectory track{.name = "particle_filter", .continuous = true};
  for (std::size_t k = 0; k < verdicts.size(); ++k)
  {
    track.points.push_back({.time = static_cast<double>(k), .verdict = verdicts[k]});
    run.filter.lost_steps += verdicts[k] == Verdict::lost ? 1 : 0;
  }
  run.methods = {{.name = "odometry"}, track};
  return run;
}

FilterStep lastStep(Verdict verdict)
{
  FilterStep step;
  step.verdict = verdict;
  step.reason = "as it ended";
  return step;
}

RunRecord closedForm(std::size_t offered, std::size_t answered, std::size_t ambiguous)
{
  RunRecord run;
  run.methods = {{.name = "tree", .frames_offered = offered, .frames_answered = answered}};
  run.methods[0].frames_ambiguous = ambiguous;
  run.methods[0].points = std::vector<PoseEstimate>(answered);  // each the only candidate of its frame
  return run;
}

constexpr Verdict kOk = Verdict::ok, kAmbiguous = Verdict::ambiguous, kLost = Verdict::lost;
}  // namespace

TEST(RunVerdict, IsThatOfTheEndNotOfTheStart)
{
  std::vector<Verdict> verdicts(20, kAmbiguous);
  verdicts.insert(verdicts.end(), 20, kOk);
  const VerdictWithReason verdict = verdictOfFilter(runOf(verdicts), lastStep(kOk));
  EXPECT_EQ(verdict.verdict, kOk);
  EXPECT_EQ(verdict.reason, "as it ended");
}

TEST(RunVerdict, TheWorseOfTheLastStepAndTheMostFrequentOfTheLastTenSeconds)
{
  std::vector<Verdict> verdicts(30, kOk);
  verdicts.back() = kLost;
  EXPECT_EQ(verdictOfFilter(runOf(verdicts), lastStep(kLost)).verdict, kLost);
  verdicts.assign(30, kAmbiguous);
  verdicts.back() = kOk;
  const VerdictWithReason lucky = verdictOfFilter(runOf(verdicts), lastStep(kOk));
  EXPECT_EQ(lucky.verdict, kAmbiguous);
  EXPECT_EQ(lucky.reason, "mostly ambiguous over the last 10 s; at the end: as it ended");
}

TEST(RunVerdict, MentionsLostStepsBefore)
{
  std::vector<Verdict> verdicts(40, kOk);
  verdicts[3] = verdicts[4] = kLost;
  const VerdictWithReason verdict = verdictOfFilter(runOf(verdicts), lastStep(kOk));
  EXPECT_EQ(verdict.verdict, kOk);
  EXPECT_EQ(verdict.reason, "as it ended; lost in 2 of 40 frames before");
}

TEST(RunVerdict, AFilterWithoutFramesIsLost)
{
  EXPECT_EQ(verdictOfFilter(runOf({}), lastStep(kOk)).verdict, kLost);
  EXPECT_EQ(verdictOfFilter({}, lastStep(kOk)).verdict, kLost);
}

TEST(RunVerdict, ClosedFormsAreJudgedByTheirBestMethod)
{
  EXPECT_EQ(verdictOfClosedForms(closedForm(10, 5, 0)).verdict, kOk);
  EXPECT_EQ(verdictOfClosedForms(closedForm(10, 5, 0)).reason, "tree answers 5 of 10 frames");
  EXPECT_EQ(verdictOfClosedForms(closedForm(10, 1, 4)).verdict, kAmbiguous);
  EXPECT_EQ(verdictOfClosedForms(closedForm(10, 4, 0)).verdict, kLost);
  EXPECT_EQ(verdictOfClosedForms(closedForm(0, 0, 0)).verdict, kLost);
  EXPECT_EQ(verdictOfClosedForms({}).verdict, kLost);
  RunRecord several = closedForm(10, 1, 0);
  several.methods.push_back({.name = "oracle_tree", .oracle = true, .frames_offered = 10, .frames_answered = 10});
  EXPECT_EQ(verdictOfClosedForms(several).verdict, kLost);  // the oracle knew the truth
  several.methods.push_back(
      {.name = "better", .points = std::vector<PoseEstimate>(8), .frames_offered = 10, .frames_answered = 8});
  EXPECT_EQ(verdictOfClosedForms(several).reason, "better answers 8 of 10 frames");
}

TEST(RunVerdict, TheBestOfSeveralCandidatesIsAmbiguous)
{
  RunRecord run = closedForm(10, 8, 0);
  std::vector<PoseEstimate> points(8);
  for (std::size_t i = 0; i < 4; ++i) points[i].verdict = kAmbiguous;
  run.methods[0].points = points;
  EXPECT_EQ(verdictOfClosedForms(run).verdict, kAmbiguous);
  points[0].verdict = kOk;
  run.methods[0].points = points;
  EXPECT_EQ(verdictOfClosedForms(run).verdict, kOk);
}
}  // namespace mrpt_ext::test_run_verdict
