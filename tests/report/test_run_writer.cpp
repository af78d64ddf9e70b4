#include "mrpt_ext/report/run_writer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_run_writer
{
using namespace testing;
namespace fs = std::filesystem;

namespace
{
class RunWriter : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    folder_ =
        fs::path(MRPT_EXT_BINARY_DIR) / "test_output" / ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::set<std::string> fileNames() const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }

  fs::path folder_;
};

std::string contentOf(const fs::path& path)
{
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}
}  // namespace

TEST_F(RunWriter, WritesTheFilesOfATrialAndNoOthers)
{
  const RunContext context = syntheticContext(30);
  const RunRecord record = syntheticRecord(context);
  writeTrial(folder_, context, record, scoreRun(context, record, {}));
  std::set<std::string> expected{"summary.json", "report.html", "steps.csv", "hypotheses.csv", "objects.csv"};
  for (const MethodTrajectory& method : record.methods) expected.insert("trajectory_" + method.name + ".tum");
  EXPECT_EQ(fileNames(), expected);
}

TEST_F(RunWriter, RemovesResultsOfAnEarlierRun)
{
  fs::create_directories(folder_);
  std::ofstream(folder_ / "trajectory_of_before.tum") << "1 0 0 0 0 0 0 1\n";
  std::ofstream(folder_ / "notes.txt") << "mine\n";
  const RunContext context = syntheticContext(30);
  const RunRecord record = syntheticRecord(context);
  writeTrial(folder_, context, record, scoreRun(context, record, {}));
  EXPECT_FALSE(fs::exists(folder_ / "trajectory_of_before.tum"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

TEST_F(RunWriter, ObjectsOnlyWhenConfigured)
{
  RunContext context = syntheticContext(10);
  RunRecord record = syntheticRecord(context);
  record.objects.clear();
  writeTrial(folder_, context, record, scoreRun(context, record, {}));
  EXPECT_FALSE(fileNames().contains("objects.csv"));
  context.objects_wanted = true;
  writeTrial(folder_, context, record, scoreRun(context, record, {}));
  EXPECT_TRUE(fileNames().contains("objects.csv"));
}

TEST_F(RunWriter, TheOdometryFileAgreesWithItsScore)
{
  const RunContext context = syntheticContext(30);
  const RunRecord record = syntheticRecord(context);
  writeTrial(folder_, context, record, scoreRun(context, record, {}));
  const Trajectory written = readTum(folder_ / "trajectory_odometry.tum");
  ASSERT_EQ(written.size(), record.methods.front().points.size());
  EXPECT_NEAR(written.front().pose.x, context.truth.front().pose.x, 1e-6);
  EXPECT_NEAR(wrap(written.front().pose.phi - context.truth.front().pose.phi), 0, 1e-6);
}

TEST_F(RunWriter, SameRunSameBytes)
{
  const RunContext context = syntheticContext(30);
  const RunRecord record = syntheticRecord(context);
  const RunScore score = scoreRun(context, record, {});
  writeTrial(folder_ / "a", context, record, score);
  writeTrial(folder_ / "b", context, record, score);
  for (const auto& entry : fs::directory_iterator(folder_ / "a"))
    EXPECT_EQ(contentOf(entry.path()), contentOf(folder_ / "b" / entry.path().filename())) << entry.path();
}

TEST_F(RunWriter, MergedTrialsAreInSubfolders)
{
  const RunContext context = syntheticContext(10);
  const RunScore score = scoreRun(context, syntheticRecord(context), {});
  writeMerged(folder_, context, mergeScores({score, score}));
  EXPECT_EQ(fileNames(), (std::set<std::string>{"report.html", "summary.json"}));
}

TEST_F(RunWriter, AnUnwritableFolderIsADataError)
{
  fs::create_directories(folder_.parent_path());
  std::ofstream(folder_) << "a file where the folder should be";
  const RunContext context = syntheticContext(10);
  const RunRecord record = syntheticRecord(context);
  EXPECT_THROW(writeTrial(folder_, context, record, scoreRun(context, record, {})), InputError);
}
}  // namespace mrpt_ext::test_run_writer
