#include "mrpt_ext/diagnosis/innovation_statistics.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_innovation_statistics
{
TEST(InnovationStatistics, TheScatterOfNormalInnovationsIsTheirStandardDeviation)
{
  RandomStream random(1);
  InnovationStatistics statistics;
  EXPECT_EQ(statistics.scatter(), 1);
  for (int k = 0; k < 20000; ++k) statistics.add(2.5 * random.gaussian());
  EXPECT_NEAR(statistics.scatter(), 2.5, 0.06);
}

TEST(OutlierStatistics, TheShareHasAStandardError)
{
  RandomStream random(1);
  OutlierStatistics statistics;
  EXPECT_EQ(statistics.shareStd(), 1);
  for (int k = 0; k < 20000; ++k) statistics.add(random.chance(0.1));
  EXPECT_EQ(statistics.count(), 20000);
  EXPECT_NEAR(statistics.share(), 0.1, 0.01);
  EXPECT_NEAR(statistics.shareStd(), std::sqrt(0.1 * 0.9 / 20000), 0.0008);
}

TEST(OutlierStatistics, OutliersInGroupsAreLessCertain)
{
  OutlierStatistics statistics;
  for (int k = 0; k < 20000; ++k) statistics.add(k < 2000);
  EXPECT_NEAR(statistics.share(), 0.1, 1e-12);
  EXPECT_GT(statistics.shareStd(), 0.03);
}
}  // namespace mrpt_ext::test_innovation_statistics
