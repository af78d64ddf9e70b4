#include "mrpt_ext/evaluation/verdict_history.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_verdict_history
{
TEST(VerdictHistory, WithoutAFrameThereIsNoShare)
{
  const VerdictHistory history;
  EXPECT_TRUE(history.spells().empty());
  EXPECT_FALSE(history.shares().ok);
}

TEST(VerdictHistory, FramesInARowAreASpell)
{
  VerdictHistory history;
  history.add(0, Verdict::ambiguous, "14 modes");
  history.add(1, Verdict::ambiguous, "not verified");
  history.add(2, Verdict::ok, "one mode");
  history.add(5, Verdict::lost, "few inliers");
  ASSERT_EQ(history.spells().size(), 3u);
  EXPECT_EQ(history.spells()[0].from, 0);
  EXPECT_EQ(history.spells()[0].to, 1);
  EXPECT_EQ(history.spells()[0].reason, "14 modes");
  EXPECT_EQ(history.spells()[2].from, 5);
  EXPECT_EQ(history.spells()[2].to, 5);
  EXPECT_EQ(history.shares().ambiguous, 0.5);
  EXPECT_EQ(history.shares().ok, 0.25);
  EXPECT_EQ(history.shares().lost, 0.25);
}

TEST(VerdictHistory, ASpellIsExplainedByTheReasonThatHeldLongest)
{
  VerdictHistory history;
  history.add(0, Verdict::ambiguous, "not initialized");
  history.add(1, Verdict::ambiguous, "not initialized");
  for (int k = 2; k < 300; ++k)
    history.add(k, Verdict::ambiguous, "not precise: " + std::to_string(1000 - k) + ".5 m and -1 deg");
  history.add(300, Verdict::ok, "one mode");
  history.add(301, Verdict::ambiguous, "14 modes");
  ASSERT_EQ(history.spells().size(), 3u);
  // Numbers change from frame to frame and are no other reason; those shown are of the second half of the time.
  EXPECT_EQ(history.spells()[0].reason, "not precise: 743.5 m and -1 deg");
  EXPECT_EQ(history.spells()[2].reason, "14 modes");
}

TEST(VerdictHistory, AReasonHoldsUntilTheNextFrame)
{
  VerdictHistory history;
  for (int k = 0; k < 5; ++k) history.add(0.1 * k, Verdict::ambiguous, "several modes");
  history.add(0.5, Verdict::ambiguous, "not verified");
  EXPECT_EQ(history.spells()[0].reason, "several modes");
  history.add(20, Verdict::ok, "one mode");  // nothing was detected in between
  EXPECT_EQ(history.spells()[0].reason, "not verified");
  EXPECT_EQ(history.spells()[0].to, 0.5);
}
}  // namespace mrpt_ext::test_verdict_history
