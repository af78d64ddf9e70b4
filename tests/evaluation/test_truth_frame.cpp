#include "mrpt_ext/evaluation/truth_frame.h"

#include <gtest/gtest.h>

#include "hand_made_runs.h"
#include "mrpt_ext/evaluation/run_scoring.h"

namespace mrpt_ext::test_truth_frame
{
namespace
{
/// A drive along an arc; the truth is what `truth_of` makes of each estimate.
template <typename TruthOf>
std::vector<JudgedEstimate> judgedArc(const TruthOf& truth_of, Verdict verdict = Verdict::ok)
{
  std::vector<JudgedEstimate> judged;
  for (int k = 0; k < 30; ++k)
  {
    JudgedEstimate entry;
    entry.estimate.verdict = verdict;
    entry.estimate.pose.mean = {4 * std::sin(0.1 * k), 4 - 4 * std::cos(0.1 * k), 0.1 * k};
    entry.truth.pose = truth_of(entry.estimate.pose.mean);
    judged.push_back(entry);
  }
  return judged;
}
}  // namespace

TEST(TruthFrame, AMapThatIsTurnedAgainstTheTruthIsTold)
{
  const Pose2 T{5, -3, kPi / 2};
  const TruthOffsetFinding found = findTruthOffset(judgedArc([&](const Pose2& pose) { return compose(T, pose); }));
  ASSERT_EQ(found.kind, TruthOffset::map);
  EXPECT_NEAR(found.T.x, T.x, 1e-9);
  EXPECT_NEAR(found.T.y, T.y, 1e-9);
  EXPECT_NEAR(found.T.phi, T.phi, 1e-9);
  EXPECT_NEAR(found.residual, 0, 1e-6);
  const std::string hint = truthOffsetHint(found);
  EXPECT_NE(hint.find("turned by 90.0 deg and moved by x 5.00 m, y -3.00 m"), std::string::npos) << hint;
}

TEST(TruthFrame, ASensorThatIsNotWhereTheTruthIsIsTold)
{
  const TruthOffsetFinding found = findTruthOffset(judgedArc(
      [](const Pose2& pose) {
        return compose(pose, {-0.6, 0.2, 0});
      }));
  ASSERT_EQ(found.kind, TruthOffset::robot);
  EXPECT_NEAR(found.T.x, -0.6, 1e-9);
  EXPECT_NEAR(found.T.y, 0.2, 1e-9);
  EXPECT_NE(truthOffsetHint(found).find("sensors.csv"), std::string::npos);
}

TEST(TruthFrame, OtherErrorsAndUnbelievedEstimatesTellNothing)
{
  int k = 0;
  const auto scattered = [&](const Pose2& pose)
  {
    const double x = ++k % 2 == 0 ? 2.0 : -2.0, y = k % 3 == 0 ? 2.0 : -1.0;
    return Pose2{pose.x + x, pose.y + y, pose.phi};
  };
  EXPECT_EQ(findTruthOffset(judgedArc(scattered)).kind, TruthOffset::none);
  const auto moved = [](const Pose2& pose) { return compose({5, -3, 1}, pose); };
  EXPECT_EQ(findTruthOffset(judgedArc(moved, Verdict::ambiguous)).kind, TruthOffset::none);
  EXPECT_EQ(findTruthOffset({}).kind, TruthOffset::none);
  EXPECT_EQ(truthOffsetHint({}), "");
}

TEST(TruthFrame, ARunThatNeverConvergedSaysSo)
{
  const auto track = testing::trackWithError("particle_filter", 0, 40, 0.5, [](double) { return 0.0; });
  const RunScore score =
      scoreRun(testing::straightRun(40), testing::recordOf({testing::movedBy({0, 0, 1}, track)}), {});
  ASSERT_EQ(score.hints.size(), 1u);
  EXPECT_TRUE(score.hints[0].starts_with("truth: ")) << score.hints[0];
  EXPECT_TRUE(scoreRun(testing::straightRun(40), testing::recordOf({track}), {}).hints.empty());
}
}  // namespace mrpt_ext::test_truth_frame
