#include "mrpt_ext/filter/kalman/distinct_hypotheses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_distinct_hypotheses
{
TEST(KeepDistinct, TheFirstOfEachGroupStaysAndAbsorbsTheOthers)
{
  struct Hypothesis
  {
    double position, weight;
  };
  std::vector<Hypothesis> hypotheses{{1, 0.5}, {5, 0.2}, {1.4, 0.1}, {5.3, 0.1}, {1.8, 0.1}};
  keepDistinct(
      hypotheses, [](const Hypothesis& a, const Hypothesis& b) { return std::abs(a.position - b.position) < 0.5; },
      [](Hypothesis& kept, const Hypothesis& other) { kept.weight += other.weight; });
  ASSERT_EQ(hypotheses.size(), 3U);
  EXPECT_EQ(hypotheses[0].position, 1);
  EXPECT_NEAR(hypotheses[0].weight, 0.6, 1e-12);
  EXPECT_NEAR(hypotheses[1].weight, 0.3, 1e-12);
  EXPECT_EQ(hypotheses[2].position, 1.8) << "compared with those kept, not with those absorbed";
}
}  // namespace mrpt_ext::test_distinct_hypotheses
