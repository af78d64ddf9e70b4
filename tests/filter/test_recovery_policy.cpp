#include "mrpt_ext/filter/integrity/recovery_policy.h"

#include <gtest/gtest.h>

#include <vector>

namespace mrpt_ext::test_recovery_policy
{
namespace
{
using Kind = Recovery::Kind;

/// Times [s] at which `kind` was due, deciding every half second.
std::vector<double> timesOf(RecoveryPolicy& policy, const PosteriorState& state, Kind kind, double until)
{
  std::vector<double> times;
  for (double t = 0.5; t <= until; t += 0.5)
    if (policy.decide(state, 0.5).kind == kind) times.push_back(t);
  return times;
}
}  // namespace

TEST(RecoveryPolicy, ReseedsAtOnceAndThenAtTheInterval)
{
  RecoveryPolicy policy({.min_interval = 2});
  EXPECT_FALSE(policy.hasInjected());
  EXPECT_EQ(timesOf(policy, {.suspicious = true}, Kind::reseed, 7), (std::vector<double>{0.5, 2.5, 4.5, 6.5}));
  EXPECT_TRUE(policy.hasInjected());
}

TEST(RecoveryPolicy, ReseedingWithoutSuccessBecomesRarerUntilTheMeasurementsAgree)
{
  RecoveryPolicy policy({.min_interval = 0.5}, 4);
  policy.start();
  EXPECT_EQ(timesOf(policy, {.suspicious = true}, Kind::reseed, 16),
            (std::vector<double>{0.5, 1.5, 3.5, 7.5, 11.5, 15.5}));
  policy.resetReseeding();
  EXPECT_EQ(timesOf(policy, {.suspicious = true}, Kind::reseed, 2), (std::vector<double>{0.5, 1.5}));
}

TEST(RecoveryPolicy, VerifiesANewModeAtGrowingIntervalsWithAFallingPrior)
{
  RecoveryPolicy policy({.relocalization_prior = 0.08});
  policy.start();
  std::vector<double> priors;
  std::vector<double> times;
  for (double t = 0.5; t <= 62; t += 0.5)
    if (const Recovery recovery = policy.decide({.unimodal = true}, 0.5); recovery.kind == Kind::verify)
    {
      times.push_back(t);
      priors.push_back(recovery.prior);
    }
  EXPECT_EQ(times, (std::vector<double>{3, 9, 21, 41, 61}));
  EXPECT_NEAR(priors[0], 0.08, 1e-12);
  EXPECT_NEAR(priors[1], 0.04, 1e-12);
  EXPECT_NEAR(priors[2], 0.02, 1e-12);
  EXPECT_NEAR(priors[4], 0.08 * 3 / 20, 1e-12);
  policy.resetVerification();
  EXPECT_EQ(timesOf(policy, {.unimodal = true}, Kind::verify, 5), (std::vector<double>{2}));  // 3 s after the last
}

TEST(RecoveryPolicy, AVerifiedModeIsTestedOnlyWhereAnotherPoseMayFit)
{
  const auto first = [](const PosteriorState& state)
  {
    RecoveryPolicy policy({});
    policy.start();
    const std::vector<double> times = timesOf(policy, state, Kind::verify, 100);
    return times.empty() ? -1 : times.front();
  };
  EXPECT_EQ(first({.unimodal = true, .verified = true}), -1);
  EXPECT_EQ(first({.unimodal = true, .verified = true, .anonymous = true}), 20);
  EXPECT_EQ(first({.unimodal = true, .verified = true, .has_trajectory = true}), 20);
}

TEST(RecoveryPolicy, AFrameThatTestsAPredictedPoseDoesNotChooseAnother)
{
  RecoveryPolicy policy({});
  policy.start();
  EXPECT_FALSE(policy.decide({.unimodal = true, .ends_gap = true}, 30).due());
  EXPECT_EQ(policy.decide({.unimodal = true}, 1).kind, Kind::verify) << "the next one";
  EXPECT_EQ(policy.decide({.suspicious = true, .ends_gap = true}, 30).kind, Kind::reseed);
}

TEST(RecoveryPolicy, SeveralModesAreVerifiedByATrajectoryOnly)
{
  RecoveryPolicy alone({}), with_trajectory({});
  EXPECT_TRUE(timesOf(alone, {}, Kind::verify, 60).empty());
  EXPECT_EQ(timesOf(with_trajectory, {.has_trajectory = true}, Kind::verify, 1), (std::vector<double>{0.5}));
}
}  // namespace mrpt_ext::test_recovery_policy
