#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "child_program.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/files/tum.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// The real program as a child: what Ctrl-C leaves, and that nothing but the one line reaches stderr.
namespace mrpt_ext::test_program
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using testing::ChildProgram;
using namespace std::chrono_literals;

long lines(const fs::path& file)
{
  const std::string text = readTextFile(file);
  return std::count(text.begin(), text.end(), '\n');
}
}  // namespace

TEST(Program, InterruptedLeavesValidPartialOutput)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "long", {"--set", "Simulation.duration_s=400"});
  const fs::path run = folder.path() / "run", out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  // So many particles that the whole log would take half a minute.
  ChildProgram child(
      "landmark-localization",
      testing::joined(
          {testing::shipped("landmark-localization", "long")},
          testing::joined(log.arguments(), {"-o", run, "--set", "LocalizationExperiment.particles_count=30000"})),
      out, err);
  while (child.running() && !fs::exists(run / "config_resolved.ini")) std::this_thread::sleep_for(50ms);
  std::this_thread::sleep_for(2s);
  child.interrupt();
  EXPECT_EQ(child.exitCode(), 1);

  EXPECT_EQ(lines(err), 1) << readTextFile(err);
  EXPECT_NE(readTextFile(err).find("interrupted"), std::string::npos);
  for (const auto& entry : fs::directory_iterator(run))
    EXPECT_EQ(entry.path().filename().string().find(".tmp-"), std::string::npos) << entry.path() << " is left over";
  if (readTextFile(err).find("the rest ends here") != std::string::npos)
    GTEST_SKIP() << "this machine is too busy to write the rest within a second";
  EXPECT_EQ(testing::summaryOf(run).at("schema"), 1);
  EXPECT_TRUE(readTextFile(run / "steps.csv").ends_with('\n'));
  const auto steps = testing::stepsOf(run);
  const Trajectory truth = readTum(log.truth);
  ASSERT_FALSE(steps.empty());
  EXPECT_LT(steps.back().time, truth.back().time - 1) << "it was not interrupted at all";
  EXPECT_EQ(TextTable(run / "hypotheses.csv", {}).size(), steps.size()) << "one mode per step";
}

// A map that takes long to read: the signal comes before any trial.
TEST(Program, InterruptedWhileItLoadsEndsWithALineWithinASecond)
{
  const testing::ScratchFolder folder;
  std::string map = "id,x,y\n";
  for (int i = 0; i < 3'000'000; ++i) map += std::to_string(i) + ",1,2\n";
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt", run = folder.path() / "run";
  const Arguments arguments{
      testing::shipped("landmark-localization", "room"), "--map", folder.write("map.csv", map), "-o", run, "--set",
      "LocalizationExperiment.max_landmarks=9000000"};
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    ChildProgram child("landmark-localization", arguments, out, err);
    child.waitUntilItHandles(signal);
    const auto begin = std::chrono::steady_clock::now();
    child.interrupt(signal);
    EXPECT_EQ(child.exitCode(), 1) << signal;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 1s);
    EXPECT_EQ(readTextFile(err), "interrupted: what was finished is on disk, the rest ends here\n");
  }
  EXPECT_FALSE(fs::exists(run));
}

const std::string kFewParticles = "LocalizationExperiment.initial_particles_count=500";

TEST(Program, AnInheritedIgnoreOfInterruptsIsKept)
{
  const testing::ScratchFolder folder;
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  ChildProgram child("landmark-localization",
                     {testing::shipped("landmark-localization", "quickstart"), "-o", folder.path() / "run",
                      "--duration", "5", "--set", kFewParticles},
                     out, err, true);
  child.waitUntilItHandles(SIGTERM);
  child.interrupt();
  EXPECT_EQ(child.exitCode(), 0) << readTextFile(err);
}

TEST(Program, OutputThatCannotBeWrittenIsAFailure)
{
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const testing::ScratchFolder folder;
  const fs::path err = folder.path() / "err.txt";
  const std::string quickstart = testing::shipped("landmark-localization", "quickstart");
  // The second one fails in the middle of its run.
  for (const testing::Arguments& arguments :
       {testing::Arguments{"--list-keys"},
        testing::Arguments{quickstart, "-o", folder.path() / "run", "--duration", "5", "--set", kFewParticles}})
  {
    ChildProgram child("landmark-localization", arguments, "/dev/full", err);
    EXPECT_EQ(child.exitCode(), 1);
    EXPECT_EQ(readTextFile(err),
              "landmark-localization: standard output cannot be written (No space left on device)\n");
  }
}

TEST(Program, SaysOneLineAboutDamage)
{
  const testing::ScratchFolder folder;
  const fs::path out = folder.path() / "out.txt", err = folder.path() / "err.txt";
  const std::string bytes = readTextFile(fs::path(MRPT_EXT_SOURCE_DIR) / "datasets" / "room_map.csv");
  ChildProgram child("landmark-localization",
                     {testing::shipped("landmark-localization", "room"), folder.write("not_a.rawlog", bytes), "-o",
                      folder.path() / "run"},
                     out, err);
  EXPECT_EQ(child.exitCode(), 1);
  EXPECT_EQ(lines(err), 1) << readTextFile(err);
  EXPECT_EQ(readTextFile(out), "");
}
}  // namespace mrpt_ext::test_program
