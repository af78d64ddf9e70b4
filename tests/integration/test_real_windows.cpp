#include <gtest/gtest.h>

#include "mrclam_trajectories.h"
#include "shared_data.h"

namespace mrpt_ext::test_real_windows
{
namespace
{
using namespace mrclam_trajectories;

TEST(RealWindows, FromRangesAndBearingsTheTruePoseIsFirstOnceTheWindowTellsEnough)
{
  const auto folder = sharedData("mrclam/MRCLAM_Dataset6");
  if (!folder) GTEST_SKIP() << "MRCLAM data set 6 is not there (LANDMARK_DATA_DIR)";
  Recording recording = importMrclam(*folder, 3);
  hideIdentities(recording);
  const Tally tally = tallyTrajectories(recording, 90);
  EXPECT_GE(tally.starts, 7);
  EXPECT_GE(tally.enough, tally.starts - 2);
  EXPECT_EQ(tally.first, tally.enough);
}
}  // namespace
}  // namespace mrpt_ext::test_real_windows
