#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/configuration/simulator_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/settings/settings.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_simulator_app
{
namespace
{
namespace fs = std::filesystem;

// Every scenario shipped for landmark-simulator; the ten hours of long.ini are shortened.
const std::vector<std::string> kScenarios{
    "quickstart.ini", "room.ini",        "half-field.ini", "goal-corners.ini", "goal-corners-stereo.ini",
    "tracking.ini",   "kidnap.ini",      "symmetric.ini",  "long.ini",         "bad-odometry.ini",
    "barriers.ini",   "uncalibrated.ini"};

fs::path scenario(const std::string& name)
{
  return fs::path(MRPT_EXT_SOURCE_DIR) / "ini" / "landmark-simulator" / name;
}

class SimulatorAppTest : public ::testing::Test
{
 protected:
  SimulatorAppTest() { registerAllClasses(); }

  int run(std::vector<std::string> arguments)
  {
    out_.str("");
    err_.str("");
    return runLandmarkSimulator(arguments, out_, err_);
  }

  /// Runs a shipped scenario into STEM.rawlog and its companions.
  int simulate(const std::string& name, const std::string& stem, const std::vector<std::string>& more = {})
  {
    std::vector<std::string> arguments{scenario(name).string(), "-o", (folder_ / (stem + ".rawlog")).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  std::string content(const std::string& file) { return readTextFile(folder_ / file); }

  testing::ScratchFolder scratch_;
  const fs::path& folder_ = scratch_.path();
  std::ostringstream out_, err_;
};
}  // namespace

TEST_F(SimulatorAppTest, RunsEveryShippedScenario)
{
  for (const std::string& name : kScenarios)
  {
    SCOPED_TRACE(name);
    const bool shortened = name == "long.ini";
    const std::vector<std::string> more =
        shortened ? std::vector<std::string>{"--set", "Simulation.duration_s=30"} : std::vector<std::string>{};
    ASSERT_EQ(simulate(name, "run", more), kExitDone) << err_.str();
    EXPECT_EQ(err_.str(), "");
    const Settings settings = Settings::load(scenario(name), simulatorKeys());
    const Trajectory truth = readTum(folder_ / "run_ground_truth.tum");
    EXPECT_DOUBLE_EQ(truth.back().time - truth.front().time,
                     shortened ? 30 : settings.number("Simulation", "duration_s"));
    EXPECT_GT(readLandmarkCsv(folder_ / "run_map.csv").size(), 1U);
    EXPECT_GT(content("run.rawlog").size(), 10000U);
  }
}

TEST_F(SimulatorAppTest, QuickstartIsRoom)
{
  EXPECT_EQ(Settings::load(scenario("quickstart.ini"), simulatorKeys()).resolvedText(),
            Settings::load(scenario("room.ini"), simulatorKeys()).resolvedText());
}

TEST_F(SimulatorAppTest, ShippedDatasetsAreReproducible)
{
  for (const std::string stem : {"room", "half-field", "goal-corners"})
  {
    SCOPED_TRACE(stem);
    ASSERT_EQ(simulate(stem + ".ini", stem), kExitDone);
    for (const std::string ending : {".rawlog", "_ground_truth.tum", "_map.csv"})
    {
      const fs::path shipped = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets" / (stem + ending);
      EXPECT_TRUE(content(stem + ending) == readTextFile(shipped)) << shipped << " differs from what is made now";
      EXPECT_LT(fs::file_size(shipped), 300000U);
    }
  }
}

TEST_F(SimulatorAppTest, SeedDecidesTheBytes)
{
  const std::vector<std::string> brief{"--set", "Simulation.duration_s=5"};
  const auto with_seed = [&](const char* seed) { return std::vector<std::string>{brief[0], brief[1], "--seed", seed}; };
  ASSERT_EQ(simulate("kidnap.ini", "a", with_seed("7")), kExitDone);
  ASSERT_EQ(simulate("kidnap.ini", "b", with_seed("7")), kExitDone);
  ASSERT_EQ(simulate("kidnap.ini", "c", with_seed("8")), kExitDone);
  EXPECT_TRUE(content("a.rawlog") == content("b.rawlog"));
  EXPECT_TRUE(content("a_map.csv") == content("b_map.csv"));
  EXPECT_FALSE(content("a.rawlog") == content("c.rawlog"));
  EXPECT_FALSE(content("a_map.csv") == content("c_map.csv"));
}

TEST_F(SimulatorAppTest, SymmetricMapIsSymmetricButForOneLandmark)
{
  ASSERT_EQ(simulate("symmetric.ini", "s"), kExitDone);
  const LandmarkTable map = readLandmarkCsv(folder_ / "s_map.csv");
  int alone = 0;
  for (const Landmark& landmark : map.all())
    alone += std::none_of(map.all().begin(), map.all().end(),
                          [&](const Landmark& other)
                          { return (landmark.position + other.position - Vector3d(14, 6, 0)).norm() < 1e-9; });
  EXPECT_EQ(alone, 1);
}

TEST_F(SimulatorAppTest, QuietSaysNothing)
{
  ASSERT_EQ(simulate("tracking.ini", "q", {"-q"}), kExitDone);
  EXPECT_EQ(out_.str() + err_.str(), "");
  ASSERT_EQ(simulate("tracking.ini", "q"), kExitDone);
  EXPECT_NE(out_.str().find("q_map.csv: 10 landmarks"), std::string::npos);
}

TEST_F(SimulatorAppTest, MistakesAreOneLineAndTheirExitCode)
{
  const std::string room = scenario("room.ini").string(), rawlog = (folder_ / "x.rawlog").string();
  const auto expectError = [&](std::vector<std::string> arguments, int code, const std::string& words)
  {
    EXPECT_EQ(run(std::move(arguments)), code);
    const std::string text = err_.str();
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_TRUE(fs::is_empty(folder_));
  };
  expectError({}, kExitUsage, "CONFIG is required");
  expectError({room}, kExitUsage, "expected -o STEM.rawlog");
  expectError({room, "-o", (folder_ / "x.txt").string()}, kExitUsage, "x.txt', expected -o STEM.rawlog");
  expectError({(folder_ / "none.ini").string(), "-o", rawlog}, kExitUsage, "cannot be read");
  expectError({room, "-o", rawlog, "--set", "Sensor_omni.rate_h=3"}, kExitUsage, "did you mean 'rate_hz'?");
  expectError({room, "-o", rawlog, "--set", "Path.turn_radius_m=5"}, kExitUsage, "does not fit");
  expectError({room, "-o", rawlog, "--set", "Map.layout=file", "--set", "Map.file=none.csv"}, kExitFailed,
              "--set Map.file=none.csv: no such file ");
}

TEST_F(SimulatorAppTest, AnswersQuestionsAboutItsKeys)
{
  EXPECT_EQ(run({"--list-keys"}), kExitDone);
  EXPECT_NE(out_.str().find("clutter_per_reading = 0"), std::string::npos);
  EXPECT_EQ(run({"--explain", "Sensor_omni.kind"}), kExitDone);
  EXPECT_NE(out_.str().find("running_fix"), std::string::npos);
  EXPECT_EQ(run({"--version"}), kExitDone);
  EXPECT_EQ(run({"--help"}), kExitDone);
  EXPECT_NE(out_.str().find("--set"), std::string::npos);
}
}  // namespace mrpt_ext::test_simulator_app
