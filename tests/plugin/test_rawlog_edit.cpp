#include <algorithm>

#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "room_walk.h"
#include "stock_tools.h"

namespace mrpt_ext::test_rawlog_edit
{
namespace
{
class StockRawlogEdit : public StockToolTest
{
 protected:
  void SetUp() override
  {
    StockToolTest::SetUp();
    if (!isInstalled("rawlog-edit")) GTEST_SKIP() << "rawlog-edit is not installed";
    writeRawlog(folder() / "room.rawlog", walkThroughRoom(10));
  }

  [[nodiscard]] std::string rawlogEdit(const std::string& operation, const std::string& plugin) const
  {
    return run("rawlog-edit --" + operation + " -i room.rawlog -p " + pluginPath(plugin).string());
  }
};
}  // namespace

TEST_F(StockRawlogEdit, InfoCountsOurClasses)
{
  for (const std::string plugin : {"observations", "maps"})
  {
    const std::string output = rawlogEdit("info", plugin);
    EXPECT_TRUE(contains(output, "camera /     17")) << output;
    EXPECT_TRUE(contains(output, "stereo /      5")) << output;
    EXPECT_TRUE(contains(output, "goal /      2")) << output;
    EXPECT_TRUE(contains(output, "odometry /     50")) << output;
    EXPECT_FALSE(contains(output, "not registered")) << output;
  }
}

TEST_F(StockRawlogEdit, DescribeShowsWhatWasSeen)
{
  const std::string output = rawlogEdit("describe", "observations");
  EXPECT_TRUE(contains(output, "ClassName: mrpt_ext::CObservationLandmarkBearings")) << output.substr(0, 2000);
  EXPECT_TRUE(contains(output, "12 bearings:"));
  EXPECT_TRUE(contains(output, "1 ranges in the floor plane:"));
  EXPECT_TRUE(contains(output, "ClassName: mrpt_ext::CObservationRunningFix"));
}

TEST_F(StockRawlogEdit, ExportTxtWritesOneTablePerSensor)
{
  const std::string output = rawlogEdit("export-txt", "observations");
  const std::string camera = readText(folder() / "room_camera.txt");
  EXPECT_TRUE(contains(camera, "N id_1 category_1 bearing_deg_1 std_bearing_deg_1 id_2")) << output << camera;
  EXPECT_TRUE(contains(camera, " 12 -1 - ")) << camera;
  EXPECT_EQ(std::count(camera.begin(), camera.end(), '\n'), 18);  // header and 17 rows
  EXPECT_TRUE(contains(readText(folder() / "room_stereo.txt"), "range_m_1"));
  EXPECT_TRUE(contains(readText(folder() / "room_goal.txt"), "second_bearing_std_deg"));
}

// Why a plugin is needed, and that the tests above would notice its absence.
TEST_F(StockRawlogEdit, WithoutThePluginTheClassIsUnknown)
{
  EXPECT_TRUE(contains(run("rawlog-edit --info -i room.rawlog"), "not registered"));
}
}  // namespace mrpt_ext::test_rawlog_edit
