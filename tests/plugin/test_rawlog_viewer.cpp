#include <fstream>

#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "room_walk.h"
#include "stock_tools.h"

namespace mrpt_ext::test_rawlog_viewer
{
namespace
{
class StockRawlogViewer : public StockToolTest
{
};

/// Starts a display of its own and RawLogViewer on it, waits for its window, prints the titles of all windows and
/// whether the viewer is still alive.
constexpr const char* kScript = R"(#!/bin/sh
export HOME="$PWD"
exec 3>display
Xvfb -displayfd 3 -noreset -screen 0 1280x1024x24 >xvfb.log 2>&1 &
xvfb=$!
while [ ! -s display ]; do sleep 0.1; kill -0 $xvfb || exit 1; done
export DISPLAY=:$(cat display)
RawLogViewer -l "$1" room.rawlog >viewer.log 2>&1 &
viewer=$!
until xwininfo -root -tree 2>/dev/null | grep -q "RawlogViewer - "; do sleep 0.2; kill -0 $viewer || break; done
xwininfo -root -tree | grep '"'
kill -0 $viewer && echo viewer alive
kill $viewer $xvfb
wait 2>/dev/null
cat xvfb.log viewer.log
)";
}  // namespace

// Its "Tip of the Day" waits for a click before the log is shown; that the classes are read is tested by rawlog-edit.
TEST_F(StockRawlogViewer, StartsWithThePluginAndALog)
{
  for (const char* program : {"RawLogViewer", "Xvfb", "xwininfo"})
    if (!isInstalled(program)) GTEST_SKIP() << program << " is not installed";
  writeRawlog(folder() / "room.rawlog", walkThroughRoom(10));
  std::ofstream(folder() / "view.sh") << kScript;
  const std::string output = run("sh ./view.sh " + pluginPath("observations").string());
  EXPECT_TRUE(contains(output, "RawlogViewer - ")) << output;
  EXPECT_TRUE(contains(output, "viewer alive")) << output;
  EXPECT_FALSE(contains(output, "not registered")) << output;
  EXPECT_FALSE(contains(output, "xception")) << output;
}
}  // namespace mrpt_ext::test_rawlog_viewer
