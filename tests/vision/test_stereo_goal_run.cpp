#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/vision/stereo/stereo_goal.h"
#include "run_images.h"
#include "scratch_folder.h"
#include "stereo_truth.h"

// From rendered stereo pairs to goal corners and line landmarks (ini/images2rawlog/stereo.ini) and poses
// (ini/landmark-localization/stereo-goal*.ini); the truth comes with the images.
namespace mrpt_ext::test_stereo_goal_run
{
namespace
{
namespace fs = std::filesystem;
using testing::LineScore;
using testing::StereoScore;

const fs::path kOwnScene = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/stereo-goal";

/// images2rawlog over a scene, and its table beside the truth.
StereoScore scoreOf(const fs::path& scene, const testing::Arguments& more = {})
{
  const testing::ScratchFolder folder;
  const fs::path csv = folder.path() / "log.csv";
  const auto outcome =
      testing::runImages(testing::joined({testing::shipped("images2rawlog", "stereo").string(), "-i", scene.string(),
                                          "-o", (folder.path() / "log.rawlog").string(), "--csv", csv.string()},
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
  const auto outcome = testing::runImages(
      {testing::shipped("images2rawlog", "stereo").string(), "-i", kOwnScene.string(), "-o", files.rawlog.string()});
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

namespace
{
/// What the camera's noise grows with: a constant and the square root of the brightness.
struct Noise
{
  double read = 0, shot = 0;  // grey levels in the dark, more at 255
};

Noise noiseOf(const fs::path& scene)
{
  std::ifstream file(scene / "camera.json");
  const auto noise = nlohmann::json::parse(file).at("noise");
  return {noise.at("read"), noise.at("shot")};
}

/// Other light and twice the noise: the channels times 1.15/1.0/0.8, times 0.7, and noise that doubles the total.
void spoil(const fs::path& image, const fs::path& to, const Noise& noise, int seed)
{
  cv::Mat colour = cv::imread(image.string(), cv::IMREAD_COLOR), added(colour.size(), CV_32FC3), sigma;
  colour.convertTo(colour, CV_32FC3);
  cv::sqrt(colour * (square(noise.shot) / 255) + cv::Scalar::all(square(noise.read)), sigma);
  cv::RNG(static_cast<std::uint64_t>(seed)).fill(added, cv::RNG::NORMAL, 0, std::sqrt(3.0));
  cv::multiply(colour, cv::Scalar(0.8 * 0.7, 1.0 * 0.7, 1.15 * 0.7), colour);
  colour += added.mul(sigma);
  colour.convertTo(colour, CV_8UC3);
  cv::imwrite(to.string(), colour, {cv::IMWRITE_PNG_COMPRESSION, 1});
}

void expectDetectionsStay(const fs::path& scene)
{
  const testing::ScratchFolder folder;
  for (const char* const name : {"camera.json", "observations.csv", "line_points.csv"})
    fs::copy_file(scene / name, folder.path() / name);
  const TextTable frames(scene / "frames.csv", {});
  const Noise noise = noiseOf(scene);
  std::string table = "frame,left,right,x_m,y_m,heading_deg\n";
  for (std::size_t row = 0; row < frames.size(); ++row)
  {
    table += frames.text(row, frames.column("frame"));
    for (const char* const side : {"left", "right"})
    {
      const std::string name = frames.text(row, frames.column("frame")) + side + ".png";
      spoil(scene / frames.text(row, frames.column(side)), folder.path() / name, noise,
            static_cast<int>(2 * row) + (side[0] == 'l' ? 1 : 2));
      table += "," + name;
    }
    for (const char* const pose : {"x_m", "y_m", "heading_deg"}) table += "," + frames.text(row, frames.column(pose));
    table += "\n";
  }
  folder.write("frames.csv", table);
  const StereoScore before = scoreOf(scene), after = scoreOf(folder.path());
  EXPECT_GE(after.found, 0.9 * before.found);
  EXPECT_EQ(after.false_corners, 0);
  const auto all = [](const StereoScore& s) { return s.found + s.near.found + s.far.found; };
  EXPECT_GE(all(after), 0.9 * all(before));
  EXPECT_GE(after.near.found, 0.9 * before.near.found);
}
}  // namespace

TEST(StereoGoalRun, OwnImagesKeepTheirLandmarksInOtherLight) { expectDetectionsStay(kOwnScene); }

TEST(StereoGoalRun, SharedImagesKeepTheirLandmarksInOtherLight)
{
  for (const std::string name : {"samples/C_qvga", "samples/C_vga"})
  {
    const auto scene = testing::sharedScene(name);
    if (!scene) GTEST_SKIP() << "the shared scenes are absent";
    expectDetectionsStay(*scene);
  }
}
}  // namespace mrpt_ext::test_stereo_goal_run
