#include "mrpt_ext/correspondence/triple_schedule.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_triple_schedule
{
namespace
{
/// All triples of so many detections.
std::vector<DetectionTriple> allTriples(int detections)
{
  std::vector<DetectionTriple> triples;
  for (int i = 0; i < detections; ++i)
    for (int j = i + 1; j < detections; ++j)
      for (int k = j + 1; k < detections; ++k) triples.push_back({{i, j, k}, 1.0 + 0.01 * (i + j + k)});
  return triples;
}
}  // namespace

TEST(TripleSchedule, DisjointTriplesTolerateOneFalseDetectionEach)
{
  WorkBudget budget;
  TripleSchedule schedule(allTriples(9), budget);
  EXPECT_EQ(schedule.tolerated(), -1);
  for (int tolerated = 0; tolerated < 3; ++tolerated)
  {
    ASSERT_TRUE(schedule.next());
    EXPECT_EQ(schedule.tolerated(), tolerated);
  }
}

TEST(TripleSchedule, AllTriplesTolerateAllButThree)
{
  WorkBudget budget;
  TripleSchedule schedule(allTriples(8), budget);
  int rounds = 0;
  while (schedule.next()) ++rounds;
  EXPECT_EQ(schedule.tolerated(), 5);
  EXPECT_LE(rounds, 56);
}

/// It took 3^20 steps and more.
TEST(TripleSchedule, OfThirtySixDetectionsEveryRoundIsShort)
{
  WorkBudget budget;
  TripleSchedule schedule(allTriples(36), budget);
  for (int round = 1; round <= 100; ++round)
  {
    const std::uint64_t before = budget.spent();
    ASSERT_TRUE(schedule.next());
    EXPECT_LT(budget.spent() - before, 1'500'000u);
    EXPECT_GE(schedule.tolerated() + 1, std::min(round, 12));
  }
}

TEST(TripleSchedule, EndsWithItsBudget)
{
  WorkBudget budget(1000);
  TripleSchedule schedule(allTriples(36), budget);
  EXPECT_FALSE(schedule.next());
  EXPECT_TRUE(budget.exhausted());
}
}  // namespace mrpt_ext::test_triple_schedule
