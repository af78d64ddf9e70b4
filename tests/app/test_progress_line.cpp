#include "mrpt_ext/app/progress_line.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_progress_line
{
TEST(ProgressText, TellsTheTimeLeftOnceThereIsSomethingToGoBy)
{
  EXPECT_EQ(progressText("localizing", 0.5, 0.4), "localizing 50 %");
  EXPECT_EQ(progressText("localizing", 0, 30), "localizing 0 %");
  EXPECT_EQ(progressText("localizing", 0.25, 4), "localizing 25 %, 12 s left");
  EXPECT_EQ(progressText("localizing", 0.1, 100), "localizing 10 %, 15 min left");
  EXPECT_EQ(progressText("localizing", 1, 9), "localizing 100 %, 0 s left");
  EXPECT_EQ(progressText("localizing", 1.2, 0), "localizing 100 %");
}
}  // namespace mrpt_ext::test_progress_line
