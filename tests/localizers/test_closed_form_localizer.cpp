#include "mrpt_ext/localizers/closed_form_localizer.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_closed_form_localizer
{
namespace
{
PoseHypothesis at(double x, double log_score, bool heading_known = true)
{
  return {.pose = {{x, 0, 1}, Matrix3d::Identity() * 0.01}, .log_score = log_score, .heading_known = heading_known};
}
}  // namespace

TEST(ClosedFormLocalizer, ReportsTheBestOfTheRankedCandidates)
{
  const Estimate estimate = estimateFrom({SolveStatus::ok, {at(1, -3), at(2, -1), at(3, -2)}}, 7);
  ASSERT_TRUE(estimate.point);
  EXPECT_EQ(estimate.status, SolveStatus::ok);
  EXPECT_FALSE(estimate.ambiguous);
  EXPECT_EQ(estimate.point->time, 7);
  EXPECT_EQ(estimate.point->pose.mean.x, 2);
  EXPECT_EQ(estimate.point->modes, 3);
  EXPECT_EQ(estimate.point->verdict, Verdict::ambiguous);
  EXPECT_NEAR(estimate.point->best_weight, 1 / (1 + std::exp(-1.0) + std::exp(-2.0)), 1e-12);
  for (const std::size_t i : {0u, 1u, 2u}) EXPECT_EQ(estimate.candidates[i].pose.mean.x, (std::array{2, 3, 1})[i]);
}

TEST(ClosedFormLocalizer, ASingleCandidateIsOk)
{
  const Estimate estimate = estimateFrom({SolveStatus::ok, {at(1, -3)}}, 0);
  ASSERT_TRUE(estimate.point);
  EXPECT_EQ(estimate.point->verdict, Verdict::ok);
  EXPECT_EQ(estimate.point->modes, 1);
  EXPECT_EQ(estimate.point->best_weight, 1);
}

TEST(ClosedFormLocalizer, ASingleDoubtfulCandidateIsAmbiguous)
{
  for (const SolveStatus status : {SolveStatus::degenerate, SolveStatus::none})
  {
    const Estimate estimate = estimateFrom({status, {at(1, -3)}}, 0);
    ASSERT_TRUE(estimate.point);
    EXPECT_EQ(estimate.status, status);
    EXPECT_EQ(estimate.point->verdict, Verdict::ambiguous);
  }
}

TEST(ClosedFormLocalizer, AnImpreciseCandidateIsAmbiguous)
{
  const auto verdict = [](bool heading_known, const ErrorLimits& limits) {
    return estimateFrom({SolveStatus::ok, {at(1, -3, heading_known)}}, 0, limits).point->verdict;
  };
  EXPECT_EQ(verdict(true, {0.29, 0.21}), Verdict::ok);  // twice the standard deviations of 0.14 m and 0.1 rad
  EXPECT_EQ(verdict(true, {0.27, 0.21}), Verdict::ambiguous);
  EXPECT_EQ(verdict(true, {0.29, 0.19}), Verdict::ambiguous);
  EXPECT_EQ(verdict(false, {0.29, 0.19}), Verdict::ok);
}

TEST(ClosedFormLocalizer, EqualScoresAreAmbiguousAndGiveNoEstimate)
{
  const Estimate estimate = estimateFrom({SolveStatus::ok, {at(1, -3), at(2, -3), at(3, -9)}}, 0);
  EXPECT_FALSE(estimate.point);
  EXPECT_TRUE(estimate.ambiguous);
  EXPECT_EQ(estimate.candidates.size(), 3u);
}

TEST(ClosedFormLocalizer, EqualScoresBehindTheBestDoNotMatter)
{
  const Estimate estimate = estimateFrom({SolveStatus::ok, {at(1, -3), at(2, -1), at(3, -3)}}, 0);
  ASSERT_TRUE(estimate.point);
  EXPECT_EQ(estimate.point->pose.mean.x, 2);
}

TEST(ClosedFormLocalizer, AnUnknownHeadingIsMarkedAndHasTheVarianceOfTheCircle)
{
  const Estimate estimate = estimateFrom({SolveStatus::ok, {at(1, 0, false)}}, 0);
  ASSERT_TRUE(estimate.point);
  EXPECT_FALSE(estimate.point->heading_known);
  EXPECT_NEAR(estimate.point->pose.covariance(2, 2), kPi * kPi / 3, 1e-12);
}

TEST(ClosedFormLocalizer, NoCandidateNoEstimate)
{
  const Estimate estimate = estimateFrom({SolveStatus::degenerate, {}}, 0);
  EXPECT_EQ(estimate.status, SolveStatus::degenerate);
  EXPECT_FALSE(estimate.point);
  EXPECT_FALSE(estimate.ambiguous);
}

TEST(ClosedFormLocalizer, AppliesTheMethodToEveryFrameSeparately)
{
  ClosedFormLocalizer localizer("mine",
                                [](const Frame& frame) {
                                  return ClosedFormResult{SolveStatus::ok, {at(frame.time, 0)}};
                                });
  EXPECT_EQ(localizer.name(), "mine");
  EXPECT_FALSE(localizer.continuous());
  for (const double time : {5.0, 2.0}) EXPECT_EQ(localizer.process({.time = time}).point->pose.mean.x, time);
}
}  // namespace mrpt_ext::test_closed_form_localizer
