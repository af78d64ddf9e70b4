#include <fstream>

#include "mrpt_ext/files/text_file.h"
#include "stock_tools.h"
#include "test_length.h"

namespace mrpt_ext::test_live_view
{
namespace
{
/// The program over the shipped quickstart run.
class LiveView : public StockToolTest
{
 protected:
  std::string command() const
  {
    return std::string(MRPT_EXT_BINARY_DIR "/bin/landmark-localization " MRPT_EXT_SOURCE_DIR
                                           "/ini/landmark-localization/quickstart.ini") +
           (testing::isShort() ? " --duration 10" : "");
  }
};

/// Starts a display of its own and the program on it, prints the titles of all windows once there is one of ours.
constexpr const char* kScript = R"(#!/bin/sh
export HOME="$PWD"
exec 3>display
Xvfb -displayfd 3 -noreset -screen 0 1280x1024x24 >xvfb.log 2>&1 &
xvfb=$!
while [ ! -s display ]; do sleep 0.1; kill -0 $xvfb || exit 1; done
export DISPLAY=:$(cat display)
"$@" &
run=$!
until xwininfo -root -tree 2>/dev/null | grep -q '"landmark-localization"'; do sleep 0.1; kill -0 $run || break; done
xwininfo -root -tree | grep '"'
wait $run
echo "exit code $?"
kill $xvfb
)";
}  // namespace

TEST_F(LiveView, FollowsARunAndChangesNothing)
{
  for (const char* program : {"Xvfb", "xwininfo"})
    if (!isInstalled(program)) GTEST_SKIP() << program << " is not installed";
  std::ofstream(folder() / "watch.sh") << kScript;
  const std::string output = run("sh ./watch.sh " + command() + " -o watched --gui --gui-speed 20");
  EXPECT_TRUE(contains(output, "\"landmark-localization\"")) << output;
  EXPECT_TRUE(contains(output, "exit code 0")) << output;
  EXPECT_FALSE(contains(output, "no window")) << output;
  EXPECT_TRUE(contains(run(command() + " -o alone"), "report   "));
  const auto track = [&](const char* name) { return readTextFile(folder() / name / "trajectory_particle_filter.tum"); };
  EXPECT_EQ(track("watched"), track("alone"));
}

TEST_F(LiveView, WithoutADisplayTheRunGoesOn)
{
  const std::string output = run("unset DISPLAY; " + command() + " -o out --gui; echo exit code \\$?");
  EXPECT_TRUE(contains(output, "--gui: no window, there is no display")) << output;
  EXPECT_TRUE(contains(output, "exit code 0")) << output;
  EXPECT_TRUE(contains(output, "report   ")) << output;
}
}  // namespace mrpt_ext::test_live_view
