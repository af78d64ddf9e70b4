#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "room_walk.h"
#include "stock_tools.h"
#include "test_length.h"

namespace mrpt_ext::test_pf_localization
{
namespace
{
const std::filesystem::path kIniFolder = std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "ini" / "pf-localization";

/// Replaces the value of a key that must be in the text.
void setKey(std::string& ini, const std::string& key, const std::string& value)
{
  const std::regex line("(^|\n)" + key + " *=[^\n]*");
  ASSERT_TRUE(std::regex_search(ini, line)) << key;
  ini = std::regex_replace(ini, line, "$1" + key + " = " + value);
}

/// In the only form that pf-localization compares correctly: `t x y phi`, the first two times not whole numbers.
void writeTruth(const std::filesystem::path& path, const Trajectory& truth)
{
  std::ofstream file(path);
  file.precision(12);
  std::fixed(file);
  for (const TimedPose& point : truth)
    if (point.time > truth.front().time + 0.05)
      file << point.time << ' ' << point.pose.x << ' ' << point.pose.y << ' ' << point.pose.phi << '\n';
}

class StockPfLocalization : public StockToolTest
{
 protected:
  void SetUp() override
  {
    StockToolTest::SetUp();
    if (!isInstalled("pf-localization")) GTEST_SKIP() << "pf-localization is not installed";
  }

  /// Runs room.ini with other files in place of its own. Errors [m] of the second half of the run, as the application
  /// itself wrote them.
  [[nodiscard]] std::vector<double> lateErrors(const std::filesystem::path& rawlog, const std::filesystem::path& map,
                                               const Trajectory& truth)
  {
    std::string ini = readText(kIniFolder / "room.ini");
    setKey(ini, "rawlog_file", rawlog.string());
    setKey(ini, "landmarks_file", map.string());
    setKey(ini, "logOutput_dir", "out\nground_truth_path_file = truth.txt");
    if (testing::isShort())
    {
      // Also at most: one that does not converge with so few would go on with 40000, beyond the time a program has.
      setKey(ini, "particles_count", "3000");
      setKey(ini, "KLD_maxSampleSize", "3000");
    }
    std::ofstream(folder() / "room.ini") << ini;
    writeTruth(folder() / "truth.txt", truth);
    output_ = run(preload("maps") + " pf-localization room.ini");
    std::vector<double> errors;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder()))
      if (entry.path().filename() == "GT_error.txt")
      {
        std::istringstream values(readText(entry.path()));
        for (double value = 0; values >> value;) errors.push_back(value);
      }
    errors.erase(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
    return errors;
  }

  std::string output_;
};

double mean(const std::vector<double>& values)
{
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}
}  // namespace

// Unseeded in the application itself: the bound is several times the error of a converged filter (about 0.1 m), and a
// filter that is not converged in a room of 10 m is metres away.
TEST_F(StockPfLocalization, FindsTheRobotInTheShippedRoom)
{
  const auto datasets = std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "datasets";
  const auto errors =
      lateErrors(datasets / "room.rawlog", datasets / "room_map.csv", readTum(datasets / "room_ground_truth.tum"));
  ASSERT_GT(errors.size(), 30U) << output_;
  if (!testing::isShort())
  {
    EXPECT_LT(mean(errors), 0.5) << output_.substr(0, 5000);
  }
  EXPECT_FALSE(contains(output_, "not registered"));
}

TEST_F(StockPfLocalization, FindsTheRobotByBearingsRangesAndFixes)
{
  const Recording recording = walkThroughRoom(40);
  writeRawlog(folder() / "walk.rawlog", recording);
  writeLandmarkCsv(folder() / "walk_map.csv", recording.map);
  const auto errors = lateErrors(folder() / "walk.rawlog", folder() / "walk_map.csv", recording.truth);
  ASSERT_GT(errors.size(), 30U) << output_;
  if (!testing::isShort())
  {
    EXPECT_LT(mean(errors), 0.5) << output_.substr(0, 5000);
  }
}

TEST_F(StockPfLocalization, RoomIniNamesFilesThatExistBelowTheRoot)
{
  std::istringstream ini(readText(kIniFolder / "room.ini"));
  std::size_t found = 0;
  const std::regex file_key("(rawlog_file|landmarks_file) = (.*)");
  for (std::string line; std::getline(ini, line);)
  {
    std::smatch match;
    if (!std::regex_match(line, match, file_key)) continue;
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(MRPT_EXT_SOURCE_DIR) / match[2].str())) << line;
    ++found;
  }
  EXPECT_EQ(found, 2U);
}
}  // namespace mrpt_ext::test_pf_localization
