#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/imgcodecs.hpp>

#include "../support/synthetic_field.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"
#include "run_images.h"
#include "scratch_folder.h"

// images2rawlog with a stereo pair, over folders and rawlogs made here.
namespace mrpt_ext::test_stereo_goal_app
{
namespace
{
namespace fs = std::filesystem;
using testing::ScratchFolder;

testing::FieldPicture goalAndCrossing()
{
  testing::FieldPicture picture;
  picture.boards.push_back({picture.wall, -0.15, 0.25, 0.05, testing::kYellow});
  picture.markings = {{{0.2, -0.1}, {0.36, 0.06}}, {{0.2, 0.06}, {0.36, -0.1}}};
  return picture;
}

constexpr const char* kCamera =
    R"({"stereo": {"width": 320, "height": 240, "fx": 300, "fy": 300, "cx": 159.5, "cy": 119.5,
 "baseline": 0.03, "forward": 0.02, "height_m": 0.06, "pitch_deg": 6}})";

testing::AppOutcome runOn(const fs::path& input, const fs::path& output, const testing::Arguments& more = {})
{
  const auto config = testing::shipped("images2rawlog", "stereo").string();
  return testing::runImages(testing::joined({config, "-i", input.string(), "-o", output.string()}, more));
}

std::vector<CObservationStereoRanges::Ptr> rangesIn(const fs::path& rawlog)
{
  std::vector<CObservationStereoRanges::Ptr> found;
  RawlogReader reader(rawlog);
  while (const auto record = reader.next())
    if (const auto seen = std::dynamic_pointer_cast<CObservationStereoRanges>(record)) found.push_back(seen);
  return found;
}

/// Both corners by their ids and the crossing by its category, at the painted positions.
void expectWhatWasPainted(const fs::path& rawlog)
{
  const auto seen = rangesIn(rawlog);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0]->sensorLabel, "stereo");
  EXPECT_TRUE(seen[0]->horizontal);
  EXPECT_NEAR(seen[0]->sensor_pose.x(), 0.02, 1e-6);
  EXPECT_NEAR(seen[0]->sensor_pose.y(), 0.015, 1e-6);
  ASSERT_EQ(seen[0]->detections.size(), 2u);
  for (const auto& detection : seen[0]->detections)
  {
    const double left = detection.id == 4 ? 0.25 : -0.15;  // yellow_l, yellow_r
    EXPECT_TRUE(detection.id == 4 || detection.id == 3);
    ASSERT_TRUE(detection.range && detection.bearing);
    EXPECT_NEAR(*detection.range, std::hypot(0.8, left), 0.02);
    EXPECT_NEAR(*detection.bearing, std::atan2(left, 0.8), degToRad(0.2));
    EXPECT_GT(detection.std_range, 0);
    EXPECT_GT(detection.std_bearing, 0);
  }
  EXPECT_EQ(seen[1]->sensorLabel, "stereo_lines");
  ASSERT_EQ(seen[1]->detections.size(), 1u);
  EXPECT_EQ(seen[1]->detections.front().category, "X");
  EXPECT_EQ(seen[1]->detections.front().id, -1);
  EXPECT_NEAR(*seen[1]->detections.front().range, std::hypot(0.28, 0.02), 0.01);
}
}  // namespace

TEST(StereoGoalApp, TurnsAFolderIntoRanges)
{
  const ScratchFolder folder;
  const auto pair = testing::paint(goalAndCrossing());
  cv::imwrite((folder.path() / "a.png").string(), pair.left);
  cv::imwrite((folder.path() / "b.png").string(), pair.right);
  folder.write("camera.json", kCamera);
  folder.write("frames.csv", "frame,left,right\n0,a.png,b.png\n");
  const fs::path log = folder.path() / "out/log.rawlog", csv = folder.path() / "out/log.csv";
  const auto outcome = runOn(folder.path(), log, {"--csv", csv, "--debug-images", folder.path() / "pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  expectWhatWasPainted(log);
  const TextTable table(csv, {});
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table.text(0, table.column("sensor")), "stereo");
  EXPECT_EQ(table.text(2, table.column("label")), "X");
  for (std::size_t row = 0; row < table.size(); ++row)
    EXPECT_GT(table.number(row, table.column("u_left")), table.number(row, table.column("u_right")));
  EXPECT_TRUE(fs::exists(folder.path() / "pictures/a.png"));
}

TEST(StereoGoalApp, ReadsStereoImagesAndTheirCameraFromARawlog)
{
  const ScratchFolder folder;
  const auto picture = goalAndCrossing();
  const auto pair = testing::paint(picture);
  const fs::path input = folder.path() / "images.rawlog";
  {
    mrpt::io::CFileGZOutputStream file(input.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    auto stereo = mrpt::obs::CObservationStereoImages::Create();
    stereo->timestamp = timestampOf(100);
    stereo->sensorLabel = "eyes";
    stereo->imageLeft = mrpt::img::CImage(pair.left, mrpt::img::DEEP_COPY);
    stereo->imageRight = mrpt::img::CImage(pair.right, mrpt::img::DEEP_COPY);
    stereo->hasImageRight = true;
    stereo->leftCamera.ncols = 320, stereo->leftCamera.nrows = 240;
    stereo->leftCamera.setIntrinsicParamsFromValues(300, 300, 159.5, 119.5);
    stereo->rightCamera = stereo->leftCamera;
    stereo->rightCameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(0.03, 0, 0, 0, 0, 0));
    stereo->cameraPose =
        mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(0.02, 0.015, 0.06, degToRad(-90), 0, degToRad(-90 - 6)));
    archive << *stereo;
    stereo->timestamp = timestampOf(101);
    stereo->hasImageRight = false;
    archive << *stereo;
  }
  const auto outcome = runOn(input, folder.path() / "log.rawlog");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "frame 1: no right image, no measurement\n");
  expectWhatWasPainted(folder.path() / "log.rawlog");
}

TEST(StereoGoalApp, CountsPairsWithoutMeasurement)
{
  const ScratchFolder folder;
  const auto pair = testing::paint(goalAndCrossing());
  cv::imwrite((folder.path() / "a.png").string(), pair.left);
  cv::imwrite((folder.path() / "black.png").string(), cv::Mat::zeros(240, 320, CV_8UC3));
  cv::imwrite((folder.path() / "large.png").string(), cv::Mat::zeros(480, 640, CV_8UC3));
  folder.write("torn.png", "no image at all");
  folder.write("camera.json", kCamera);
  folder.write("frames.csv",
               "frame,left,right\n0,a.png,absent.png\n1,black.png,a.png\n2,a.png,large.png\n"
               "3,torn.png,a.png\n4,a.png,a.png\n");
  const auto outcome = runOn(folder.path(), folder.path() / "log.rawlog");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("5 frames, 0 measurements, 5 frames without measurement"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(outcome.err,
            "a.png: right image is missing, empty or damaged, no measurement\n"
            "black.png: left image is black or of one colour, no measurement\n"
            "a.png: right image is 640x480 pixels, expected 320x240, no measurement\n"
            "torn.png: left image is missing, empty or damaged, no measurement\n");
}

TEST(StereoGoalApp, TellsWhichConstantOfTheCameraIsNotAsStated)
{
  const ScratchFolder folder;
  const fs::path images = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/stereo-goal", log = folder.path() / "log.rawlog";
  EXPECT_EQ(runOn(images, log).err, "");
  EXPECT_NE(runOn(images, log, {"--set", "StereoGoal.pitch_deg=8.5"}).err.find("pitch_deg would be 6.9"),
            std::string::npos);
  EXPECT_NE(runOn(images, log, {"--set", "StereoGoal.baseline_m=0.033"}).err.find("baseline_m would be 0.0300"),
            std::string::npos);
  EXPECT_EQ(runOn(images, log, {"--set", "StereoGoal.pitch_deg=8.5", "--set", "StereoGoal.agreement_frames=0"}).err,
            "");
}

TEST(StereoGoalApp, LeavesOutCornersOfPairsThatDoNotAgreeWithTheOthers)
{
  const ScratchFolder folder;
  const fs::path shown = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/stereo-goal", images = folder.path() / "images";
  fs::copy(shown, images);
  for (const char* const name : {"field_01_R.jpg", "field_04_R.jpg", "field_07_R.jpg", "field_10_R.jpg"})
  {  // a camera that has been knocked
    const cv::Mat before = cv::imread((shown / name).string());
    cv::Mat after = before.clone();
    before.rowRange(0, before.rows - 3).copyTo(after.rowRange(3, before.rows));
    cv::imwrite((images / name).string(), after, {cv::IMWRITE_JPEG_QUALITY, 95});
  }
  const auto outcome = runOn(images, folder.path() / "log.rawlog");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("left out that others contradict"), std::string::npos) << outcome.out;
}

TEST(StereoGoalApp, ReportsMissingValuesInOneLine)
{
  const ScratchFolder folder;
  const auto expect = [&](const std::string& text)
  {
    const auto outcome = runOn(folder.path(), folder.path() / "log.rawlog");
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  };
  folder.write("frames.csv", "frame,left\n0,a.png\n");
  expect("right");
  folder.write("frames.csv", "frame,left,right\n0,a.png,b.png\n");
  expect("[StereoGoal] image_width is missing, expected it here or as width in camera.json");
  folder.write("camera.json", R"({"stereo": {"width": "wide"}})");
  expect("camera.json: width is no number");
  folder.write("camera.json", R"({"stereo": {"width": 320, "height": 240, "fx": 0, "fy": 300, "cx": 159.5, "cy": 119.5,
 "baseline": 0.03, "forward": 0, "height_m": 0.06, "pitch_deg": 6}})");
  expect("expected fx, fy, baseline and height_m above 0");
}
}  // namespace mrpt_ext::test_stereo_goal_app
