#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// A user's mistakes and damaged data: one clear line on stderr and the exit code of the contract. Wrong usage and
// configuration is 2; a file that is named but cannot be read, is damaged or cannot be used is 1.
namespace mrpt_ext::test_mistakes
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;

fs::path room() { return testing::shipped("landmark-localization", "room"); }
std::string bytesOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

fs::path roomLog() { return fs::path(MRPT_EXT_SOURCE_DIR) / "datasets" / "room.rawlog"; }

class Mistake : public ::testing::Test
{
 protected:
  /// Every part of `parts` is in the one line on stderr, and nothing is written.
  void expectError(const Arguments& arguments, int exit_code, const std::vector<std::string>& parts)
  {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const fs::path output = folder_.path() / "output";
    const auto outcome = testing::localize(testing::joined(arguments, {"-o", output}));
    EXPECT_EQ(outcome.exit_code, exit_code);
    for (const std::string& part : parts) EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with('\n'));
    EXPECT_FALSE(fs::exists(output));
  }

  /// A copy of room.ini in the scratch folder in which `from` is replaced.
  fs::path editedRoom(const std::string& from, const std::string& to)
  {
    std::string text = readTextFile(room());
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return folder_.write("edited.ini", text);
  }

  testing::ScratchFolder folder_;
};
}  // namespace

TEST_F(Mistake, InTheConfiguration)
{
  expectError({editedRoom("std_xy_per_m ", "std_xy_perm ")}, 2,
              {"edited.ini:", "unknown key 'std_xy_perm'", "did you mean 'std_xy_per_m'?"});
  expectError({editedRoom("[MotionModel]", "[MotionModels]")}, 2, {"edited.ini:", "MotionModels", "MotionModel"});
  expectError({editedRoom("random_seed             = 1", "random_seed             = one")}, 2,
              {"edited.ini:", "random_seed", "expected"});
  expectError({editedRoom("= analytic", "= analytik")}, 2, {"edited.ini:", "analytik", "analytic"});
  const std::string text = readTextFile(editedRoom("std_xy_per_m ", "std_xy_perm "));
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find("std_xy_perm")), '\n');
  expectError({folder_.path() / "edited.ini"}, 2, {"edited.ini:" + std::to_string(line) + ":"});
}

TEST_F(Mistake, OnTheCommandLine)
{
  expectError({}, 2, {"CONFIG"});
  expectError({folder_.path() / "none.ini"}, 2, {"CONFIG ", "none.ini", "expected an .ini file"});
  expectError({folder_.path()}, 2, {"expected an .ini file or a rawlog; `dataset2rawlog csv FOLDER"});
  expectError({folder_.write("detections.csv", "t,sensor\n")}, 2, {"expected an .ini file or a rawlog"});
  expectError({room(), "--nonsense"}, 2, {"--nonsense"});
  expectError({room(), "--set", "MotionModel.std_xy_perm=1"}, 2, {"did you mean 'std_xy_per_m'?"});
  expectError({room(), "--set", "MotionModel.std_xy_per_m=-1"}, 2, {"std_xy_per_m=-1", "at least 0"});
  expectError({room(), "--set", "LocalizationExperiment.methods=partcle_filter"}, 2,
              {"partcle_filter", "did you mean 'particle_filter'?"});
  expectError({room(), "--set", "LocalizationExperiment.init_PDF_max_x=-1"}, 2, {"init_PDF_max_x", "init_PDF_min_x"});
  expectError({room(), "--trials", "3:1"}, 2, {"--trials 3:1", "A:B"});
  expectError({room(), "--jobs", "0"}, 2, {"--jobs"});
  expectError({room(), "--duration", "-3"}, 2, {"--duration"});
  expectError({room(), "--set", "MetricMap_landmarkMap2D_00_creationOpts.landmarks_file="}, 2,
              {"landmarks_file", "--map"});
}

TEST(MethodNames, EveryMethodThatTheKeyNamesCanRun)
{
  std::string names;
  for (const KeyChoice& method : methodNames()) names += method.name + ' ';
  const auto outcome = testing::localize({room(), "--dry-run", "--set", "LocalizationExperiment.methods=" + names,
                                          "--set", "LocalizationExperiment.join_window_s=1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto help = testing::localize({"--explain", "methods"});
  for (const KeyChoice& method : methodNames())
    EXPECT_NE(help.out.find("    " + method.name + ' '), std::string::npos) << help.out;
}

TEST_F(Mistake, MissingFiles)
{
  const auto none = [&](const std::string& name) { return (folder_.path() / name).string(); };
  expectError({room(), none("none.rawlog")}, 1, {"RAWLOG " + none("none.rawlog") + ": no such file"});
  expectError({room(), "--map", none("none.csv")}, 1, {"--map " + none("none.csv") + ": no such file"});
  expectError({room(), "--ground-truth", none("none.tum")}, 1,
              {"--ground-truth " + none("none.tum") + ": no such file"});
  const fs::path map = roomLog().parent_path() / "room_map.csv";
  expectError({editedRoom("../../datasets/room.rawlog", "none.rawlog"), "--map", map}, 1,
              {"edited.ini:", ": rawlog_file = none.rawlog: no such file"});
  expectError({room(), folder_.path()}, 1, {"is a folder"});
}

TEST_F(Mistake, DamagedFiles)
{
  const std::string bytes = bytesOf(roomLog()), content = readTextFile(roomLog());
  expectError({room(), folder_.write("cut.rawlog", bytes.substr(0, bytes.size() / 2))}, 1,
              {"cut.rawlog: record ", "truncated"});
  expectError({room(), folder_.write("short.rawlog", content.substr(0, content.size() / 2))}, 1,
              {"short.rawlog: record ", "in the middle"});
  expectError({room(), folder_.write("text.rawlog", "this is no log\n")}, 1, {"text.rawlog"});
  expectError({room(), "--map", folder_.write("bad.csv", "id,x,y,z,category\n1,0.5,abc,0,\n")}, 1,
              {"bad.csv:2", "abc"});
  expectError({room(), "--ground-truth", folder_.write("bad.tum", "1 2 3 0 0 0 0 1\n2 3 4 0 0 0\n")}, 1, {"bad.tum:2"});
}

TEST_F(Mistake, UnknownObservationClass)
{
  std::string content = readTextFile(roomLog());
  const std::string known = "CObservationLandmarkBearings", unknown = "CObservationLandmarkBearingz";
  for (auto at = content.find(known); at != std::string::npos; at = content.find(known, at))
    content.replace(at, known.size(), unknown);
  expectError({room(), folder_.write("strange.rawlog", content)}, 1,
              {"strange.rawlog: record ", "unknown class", unknown});
}

TEST_F(Mistake, NothingToScore)
{
  Recording recording;
  for (int i = 0; i < 5; ++i) recording.records.push_back(OdometryRecord{1000.0 + i, {0.1 * i, 0, 0}});
  const fs::path log = folder_.path() / "odometry.rawlog";
  writeRawlog(log, recording);
  expectError({room(), log}, 1, {"odometry.rawlog", "5 CObservationOdometry"});
  expectError({room(), "--start", "1000"}, 1, {"room.rawlog"});
}

TEST_F(Mistake, OutputThatCannotBeWritten)
{
  const fs::path file = folder_.write("file", "in the way");
  const auto outcome = testing::localize({room(), "--duration", "1", "-o", file / "output"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("file/output"), std::string::npos) << outcome.err;
}
}  // namespace mrpt_ext::test_mistakes
