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

TEST(VerdictHistory, FramesInARowAreASpellWithTheReasonOfTheFirst)
{
  VerdictHistory history;
  history.add(0, Verdict::ambiguous, "14 modes");
  history.add(1, Verdict::ambiguous, "2 modes");
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
}  // namespace mrpt_ext::test_verdict_history
