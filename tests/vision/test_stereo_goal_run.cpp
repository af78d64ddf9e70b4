#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "../files/scratch_folder.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/vision/stereo_goal.h"
#include "run_images.h"
#include "stereo_truth.h"

// From rendered stereo pairs to goal corners and line landmarks (ini/images2rawlog/stereo-goal.ini) and poses
// (ini/landmark-localization/stereo-goal*.ini); the truth comes with the images.
namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;
using testing::LineScore;
using testing::StereoScore;

const fs::path kOwnScene = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/stereo-goal";

/// images2rawlog over a scene, and what its table says beside the truth.
StereoScore scoreOf(const fs::path& scene, const testing::Arguments& more = {})
{
  const testing::ScratchFolder folder;
  const fs::path csv = folder.path() / "log.csv";
  const auto outcome = testing::runImages(
      testing::joined({testing::shipped("images2rawlog", "stereo-goal").string(), "-i", scene.string(), "-o",
                       (folder.path() / "log.rawlog").string(), "--csv", csv.string()},
                      more));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return testing::scoreStereo(csv, scene);
}

void expectCorners(const StereoScore& score, double mean_range_error)
{
  EXPECT_GE(score.found, 0.95 * score.visible);
  EXPECT_EQ(score.false_corners, 0);
  EXPECT_LE(score.meanRangeError(), mean_range_error);
}

testing::Arguments wholePixels() { return {"--set", "StereoGoal.disparity=whole_pixels"}; }
}  // namespace

TEST(StereoGoalRun, OwnImagesGiveCornersAndLineLandmarks)
{
  const StereoScore score = scoreOf(kOwnScene);
  expectCorners(score, 0.016);
  EXPECT_EQ(score.near.found, score.near.visible);
  EXPECT_GE(score.far.found, 0.75 * score.far.visible);
  EXPECT_EQ(score.false_landmarks, 0);
  expectCorners(scoreOf(kOwnScene, wholePixels()), 0.038);
}

TEST(StereoGoalRun, OwnImagesGivePosesByCornersByLinesAndByBoth)
{
  const testing::ScratchFolder folder;
  const auto files = testing::logFiles(folder.path(), "log");
  const auto outcome = testing::runImages({testing::shipped("images2rawlog", "stereo-goal").string(), "-i",
                                           kOwnScene.string(), "-o", files.rawlog.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const std::string name : {"stereo-goal", "stereo-goal-corners", "stereo-goal-lines"})
  {
    const auto summary = testing::summaryOf(testing::localized(folder.path(), name, files.arguments()));
    EXPECT_EQ(summary.at("verdict"), "ok") << name;
    EXPECT_LT(testing::positionRmse(summary), 0.03) << name;
  }
}

TEST(StereoGoalRun, SharedImagesOfQuarterSizeGiveCornersAndLineLandmarks)
{
  const auto scene = testing::sharedScene("samples/C_qvga");
  if (!scene) GTEST_SKIP() << "the shared scenes are absent";
  const StereoScore score = scoreOf(*scene);
  expectCorners(score, 0.016);
  EXPECT_EQ(score.near.found, score.near.visible);
  expectCorners(scoreOf(*scene, wholePixels()), 0.038);
}

TEST(StereoGoalRun, SharedImagesOfFullSizeGiveCornersAndLineLandmarks)
{
  const auto scene = testing::sharedScene("samples/C_vga");
  if (!scene) GTEST_SKIP() << "the shared scenes are absent";
  const StereoScore score = scoreOf(*scene);
  expectCorners(score, 0.011);
  EXPECT_EQ(score.near.found, score.near.visible);
  EXPECT_GE(score.far.found, 0.75 * score.far.visible);
  expectCorners(scoreOf(*scene, wholePixels()), 0.022);
}
}  // namespace mrpt_ext
