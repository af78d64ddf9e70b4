#include "mrpt_ext/diagnosis/time_blocks.h"

#include <gtest/gtest.h>

#include <numeric>

namespace mrpt_ext::test_time_blocks
{
TEST(TimeBlocks, KeepTheSumInConstantMemory)
{
  TimeBlocks<double> blocks(0.0);
  for (int k = 1; k <= 1024; ++k)
  {
    blocks.open() += k;
    blocks.endItem();
    EXPECT_LT(blocks.complete().size(), 64u);
  }
  EXPECT_EQ(blocks.complete().size(), 32u);
  EXPECT_EQ(std::accumulate(blocks.complete().begin(), blocks.complete().end(), 0.0), 1024 * 1025 / 2);
  EXPECT_EQ(blocks.complete().front(), 32 * 33 / 2);
}
}  // namespace mrpt_ext::test_time_blocks
