#include "mrpt_ext/geometry/work_budget.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_work_budget
{
TEST(WorkBudget, EndsWhenItsOperationsAreUsedUp)
{
  WorkBudget budget(10);
  EXPECT_TRUE(budget.spend(9));
  EXPECT_EQ(budget.left(), 1u);
  EXPECT_FALSE(budget.exhausted());
  EXPECT_FALSE(budget.spend(5));
  EXPECT_TRUE(budget.exhausted());
  EXPECT_EQ(budget.spent(), 10u) << "what was refused is not done";
  EXPECT_EQ(budget.left(), 0u);
  EXPECT_FALSE(budget.spend(0));
}

TEST(WorkBudget, WithoutALimitItOnlyCounts)
{
  WorkBudget budget;
  EXPECT_TRUE(budget.spend(1'000'000'000'000));
  EXPECT_EQ(budget.spent(), 1'000'000'000'000u);
}

TEST(WorkBudget, AShareIsSpentWithTheWhole)
{
  WorkBudget whole(100);
  whole.spend(20);
  WorkBudget half(whole, 0.5);
  EXPECT_EQ(half.limit(), 40u);
  EXPECT_TRUE(half.spend(30));
  EXPECT_EQ(whole.spent(), 50u);
  EXPECT_FALSE(half.spend(3000));
  EXPECT_FALSE(whole.exhausted()) << "what a share was refused is left to the others";
  EXPECT_EQ(whole.left(), 40u);
  WorkBudget rest = WorkBudget::partOf(whole, 1000);
  EXPECT_EQ(rest.limit(), 40u);
  EXPECT_FALSE(rest.spend(40));
  EXPECT_TRUE(whole.exhausted());
}

TEST(WorkBudget, AFlagEndsItAndItsShares)
{
  std::atomic<bool> stop{false};
  WorkBudget whole(WorkBudget::kUnlimited, &stop);
  WorkBudget share(whole, 0.5);
  EXPECT_TRUE(share.spend(1'000));
  stop = true;
  EXPECT_TRUE(whole.isStopped());
  EXPECT_TRUE(share.exhausted());
  EXPECT_FALSE(share.spend(1));
}
}  // namespace mrpt_ext::test_work_budget
