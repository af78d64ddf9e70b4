#include <gtest/gtest.h>

#include <chrono>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "child_program.h"
#include "mrpt_ext/files/text_file.h"
#include "scratch_folder.h"
#include "synthetic_mirror.h"

// SIGTERM in the longest step of every app. Each job would take a minute or more; the contract gives an app a second to
// end, and so that a busy machine fails no test, the tests wait for longer than that, but not for the job.
namespace mrpt_ext::test_signals
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using testing::ChildProgram;
using testing::ScratchFolder;
using namespace std::chrono_literals;

constexpr double kAtWork = 1;  ///< [s] of processor time after which an app is in its longest step
const std::string kEndsHere = "interrupted: what was finished is on disk, the rest ends here\n";

/// Sends SIGTERM to an app that works and returns what it then says.
std::string terminated(ChildProgram& child, const fs::path& err)
{
  EXPECT_TRUE(child.running()) << "it was done before the signal: " << readTextFile(err);
  const auto begin = std::chrono::steady_clock::now();
  child.interrupt(SIGTERM);
  EXPECT_EQ(child.exitCode(), 1);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
  return readTextFile(err);
}

std::vector<std::string> filesIn(const fs::path& folder)
{
  std::vector<std::string> names;
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}
}  // namespace

// Twenty thousand landmarks without names: the first search alone takes longer than the test.
TEST(Signals, LocalizationEndsWhileItSearches)
{
  const ScratchFolder folder;
  const auto log =
      testing::simulated(folder.path(), "room",
                         {"--set", "Map.layout=random", "--set", "Map.count=20000", "--set", "Map.box=0 450 0 450 0 0",
                          "--set", "Map.with_ids=false", "--set", "Sensor_omni.max_range_m=8"});
  const fs::path run = folder.path() / "run", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child(
      "landmark-localization",
      testing::joined(testing::joined({testing::shipped("landmark-localization", "room")}, log.arguments()),
                      {"-o", run, "--set", "LocalizationExperiment.methods=particle_filter"}),
      out, err);
  while (child.running() && !fs::exists(run / "config_resolved.ini")) std::this_thread::sleep_for(20ms);
  child.waitUntilItHasWorked(kAtWork);
  const std::string said = terminated(child, err);
  EXPECT_TRUE(said.starts_with("interrupted")) << said;
  EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
  for (const std::string& name : filesIn(run)) EXPECT_NE(name.front(), '.') << name << " is left over";
}

// What was finished are the trials.
TEST(Signals, LocalizationEndsAmongItsTrials)
{
  const ScratchFolder folder;
  const fs::path run = folder.path() / "run", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("landmark-localization",
                     {testing::shipped("landmark-localization", "quickstart"), "-o", run, "--duration", "6", "--repeat",
                      "10000", "--set", "LocalizationExperiment.methods=odometry particle_filter", "--set",
                      "LocalizationExperiment.initial_particles_count=2000"},
                     out, err);
  while (child.running() && !fs::exists(run / "trial_002" / "summary.json")) std::this_thread::sleep_for(20ms);
  const std::string said = terminated(child, err);
  EXPECT_TRUE(said.starts_with("interrupted")) << said;
  EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
  for (const char* trial : {"trial_000", "trial_001", "trial_002"})
  {
    EXPECT_EQ(testing::summaryOf(run / trial).at("schema"), 1);
    EXPECT_FALSE(testing::stepsOf(run / trial).empty());
  }
}

TEST(Signals, SimulatorEndsWhileItDrives)
{
  const ScratchFolder folder;
  const fs::path made = folder.path() / "made", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("landmark-simulator",
                     {testing::shipped("landmark-simulator", "room"), "--set", "Simulation.duration_s=2000000", "-o",
                      made / "long.rawlog"},
                     out, err);
  child.waitUntilItHasWorked(kAtWork);
  EXPECT_EQ(terminated(child, err), kEndsHere);
  EXPECT_EQ(filesIn(made), std::vector<std::string>{});
}

TEST(Signals, ImporterEndsWhileItReads)
{
  const ScratchFolder folder;
  std::string rows = "t,sensor,id,category,bearing_deg,range_m,std_bearing_deg,std_range_m\n";
  for (int i = 0; i < 4'000'000; ++i) rows += std::to_string(i) + ",omni,1,,10.5,3.25,1,0.1\n";
  fs::create_directories(folder.path() / "recording");
  folder.write("recording/detections.csv", rows);
  folder.write("recording/landmarks.csv", "id,x,y,z,category\n1,4,0,0,pole\n");
  const fs::path made = folder.path() / "made", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("dataset2rawlog", {"csv", folder.path() / "recording", "-o", made / "log.rawlog"}, out, err);
  child.waitUntilItHasWorked(kAtWork);
  EXPECT_EQ(terminated(child, err), kEndsHere);
  EXPECT_EQ(filesIn(made), std::vector<std::string>{});
}

TEST(Signals, ImageMeasurementEndsBetweenItsImages)
{
  const ScratchFolder folder;
  cv::imwrite((folder.path() / "mirror.png").string(), testing::paint(testing::MirrorPicture(), 1));
  folder.write("camera.json", R"({"camera": {"width": 640, "height": 480}})");
  std::string frames = "frame,image,t\n";
  for (int i = 0; i < 20000; ++i) frames += std::to_string(i) + ",mirror.png," + std::to_string(i) + "\n";
  folder.write("frames.csv", frames);
  const fs::path made = folder.path() / "made", pictures = folder.path() / "pictures";
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("images2rawlog",
                     {testing::shipped("images2rawlog", "conic-mirror"), "-i", folder.path(), "-o", made / "log.rawlog",
                      "--debug-images", pictures},
                     out, err);
  while (child.running() && !fs::exists(pictures / "mirror.png")) std::this_thread::sleep_for(20ms);
  child.waitUntilItHasWorked(kAtWork);
  EXPECT_EQ(terminated(child, err), kEndsHere);
  EXPECT_EQ(filesIn(made), std::vector<std::string>{});
  EXPECT_FALSE(cv::imread((pictures / "mirror.png").string()).empty()) << "a picture is whole";
  EXPECT_EQ(filesIn(pictures).size(), 1U) << "and nothing half is beside it";
}

TEST(Signals, ReportKeepsTheOldOneWhenItEnds)
{
  const ScratchFolder folder;
  const fs::path run = folder.path() / "run", html = folder.path() / "report" / "all.html";
  ASSERT_EQ(testing::localize({testing::shipped("landmark-localization", "quickstart"), "-o", run, "--duration", "5",
                               "--set", "LocalizationExperiment.methods=odometry", "-q"})
                .exit_code,
            0);
  Arguments arguments{"-o", html};
  fs::create_directories(folder.path() / "runs");
  for (int i = 0; i < 20000; ++i)
  {
    arguments.push_back(folder.path() / "runs" / std::to_string(i));
    fs::create_directory_symlink(run, arguments.back());
  }
  fs::create_directories(html.parent_path());
  folder.write("report/all.html", "the one before");
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("localization-report", arguments, out, err);
  child.waitUntilItHasWorked(kAtWork);
  EXPECT_EQ(terminated(child, err), kEndsHere);
  EXPECT_EQ(readTextFile(html), "the one before");
  EXPECT_EQ(filesIn(html.parent_path()), std::vector<std::string>{"all.html"});
}
}  // namespace mrpt_ext::test_signals
