#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"
#include "run_images.h"
#include "scratch_folder.h"
#include "synthetic_mirror.h"

// images2rawlog over folders and rawlogs made here.
namespace mrpt_ext::test_images_app
{
namespace
{
namespace fs = std::filesystem;
using testing::ScratchFolder;

testing::AppOutcome runOn(const fs::path& input, const fs::path& output, const testing::Arguments& more = {})
{
  const auto config = testing::shipped("images2rawlog", "conic-mirror").string();
  return testing::runImages(testing::joined({config, "-i", input.string(), "-o", output.string()}, more));
}

/// The bearings observations of a rawlog, and how many odometry records are with them.
struct LogContent
{
  std::vector<CObservationLandmarkBearings::Ptr> bearings;
  int odometry = 0;
};

LogContent contentOf(const fs::path& rawlog)
{
  LogContent content;
  RawlogReader reader(rawlog);
  while (const auto record = reader.next())
  {
    if (const auto seen = std::dynamic_pointer_cast<CObservationLandmarkBearings>(record))
      content.bearings.push_back(seen);
    if (std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(record)) ++content.odometry;
  }
  return content;
}
}  // namespace

TEST(ImagesApp, TurnsAFolderIntoBearings)
{
  const ScratchFolder folder;
  const testing::MirrorPicture picture;
  cv::imwrite((folder.path() / "first.png").string(), testing::paint(picture, 1));
  cv::imwrite((folder.path() / "second.png").string(), testing::paint(picture, 2));
  folder.write("camera.json", R"({"camera": {"width": 640, "height": 480, "mount_yaw_deg": 30}})");
  folder.write("frames.csv",
               "frame,image,t,x_m,y_m,heading_deg,odometry_x_m,odometry_y_m,odometry_heading_deg\n"
               "0,first.png,10.5,1,2,90,0,0,0\n1,second.png,11,1,2.5,90,0.5,0,0\n");
  folder.write("map.csv", "id,name,x_m,y_m\n4,door,1,0\n7,board,3,2\n");
  const fs::path log = folder.path() / "out/log.rawlog", csv = folder.path() / "out/log.csv";
  const auto outcome = runOn(folder.path(), log, {"--csv", csv, "--debug-images", folder.path() / "pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("2 frames, 14 measurements, 0 frames without measurement"), std::string::npos)
      << outcome.out;

  const LogContent content = contentOf(log);
  EXPECT_EQ(content.odometry, 2);
  ASSERT_EQ(content.bearings.size(), 2u);
  EXPECT_EQ(content.bearings[0]->sensorLabel, "omni");
  EXPECT_NEAR(secondsOf(content.bearings[1]->timestamp), 11.0, 1e-6);
  ASSERT_EQ(content.bearings[0]->detections.size(), picture.sectors.size());
  EXPECT_NEAR(content.bearings[0]->detections.front().bearing, degToRad(-170 + 30), degToRad(0.12));
  EXPECT_EQ(content.bearings[0]->detections.front().id, -1);
  EXPECT_GT(content.bearings[0]->detections.front().std_bearing, 0);

  const TextTable table(csv, {});
  EXPECT_EQ(table.columns(),
            (std::vector<std::string>{"frame", "time_s", "sensor", "label", "azimuth_deg", "std_azimuth_deg", "range_m",
                                      "std_range_m", "u_left", "u_right"}));
  ASSERT_EQ(table.size(), 14u);
  EXPECT_EQ(table.text(0, table.column("label")), "edge");
  EXPECT_NEAR(table.number(0, table.column("azimuth_deg")), -140, 0.12);
  EXPECT_FALSE(table.optionalNumber(0, table.column("range_m")));
  EXPECT_TRUE(fs::exists(folder.path() / "pictures/first.png"));
  EXPECT_TRUE(fs::exists(folder.path() / "out/log_map.csv"));
  EXPECT_TRUE(fs::exists(folder.path() / "out/log_ground_truth.tum"));
}

TEST(ImagesApp, CountsImagesWithoutMeasurement)
{
  const ScratchFolder folder;
  cv::imwrite((folder.path() / "good.png").string(), testing::paint({}));
  cv::imwrite((folder.path() / "black.png").string(), cv::Mat::zeros(480, 640, CV_8U));
  cv::imwrite((folder.path() / "small.png").string(), cv::Mat::zeros(240, 320, CV_8UC3));
  folder.write("torn.png", "no image at all");
  // Decoders fill the missing part with grey, in which edges would be found.
  for (const std::string kind : {".jpg", ".png"})
  {
    std::vector<uchar> bytes;
    cv::imencode(kind, testing::paint({}), bytes);
    folder.write("cut" + kind,
                 std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2)));
  }
  folder.write("camera.json", R"({"camera": {"width": 640, "height": 480}})");
  folder.write("frames.csv",
               "frame,image\n0,good.png\n1,black.png\n2,small.png\n3,torn.png\n4,absent.png\n5,cut.jpg\n6,cut.png\n");
  const auto outcome = runOn(folder.path(), folder.path() / "log.rawlog", {"--debug-images", folder.path() / "seen"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("7 frames, 7 measurements, 6 frames without measurement"), std::string::npos);
  EXPECT_EQ(outcome.err,
            "black.png: no mirror found, no measurement\n"
            "small.png: image is 320x240 pixels, expected 640x480, no measurement\n"
            "torn.png: image is missing, empty or damaged, no measurement\n"
            "absent.png: image is missing, empty or damaged, no measurement\n"
            "cut.jpg: image is missing, empty or damaged, no measurement\n"
            "cut.png: image is missing, empty or damaged, no measurement\n");
  EXPECT_EQ(contentOf(folder.path() / "log.rawlog").bearings.size(), 1u);
}

TEST(ImagesApp, ReadsImagesOfARawlog)
{
  const ScratchFolder folder;
  const fs::path input = folder.path() / "images.rawlog";
  {
    mrpt::io::CFileGZOutputStream file(input.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    auto odometry = mrpt::obs::CObservationOdometry::Create();
    odometry->timestamp = timestampOf(100);
    odometry->sensorLabel = "odometry";
    archive << *odometry;
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = timestampOf(100.25);
    image->sensorLabel = "mirror";
    image->cameraPose = mrpt::poses::CPose3D(0.1, 0, 0.8, degToRad(30), 0, 0);
    image->image = mrpt::img::CImage(testing::paint({}), mrpt::img::DEEP_COPY);
    archive << *image;
  }
  const auto outcome = runOn(input, folder.path() / "log.rawlog");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const LogContent content = contentOf(folder.path() / "log.rawlog");
  EXPECT_EQ(content.odometry, 1);
  ASSERT_EQ(content.bearings.size(), 1u);
  EXPECT_NEAR(secondsOf(content.bearings[0]->timestamp), 100.25, 1e-6);
  EXPECT_NEAR(content.bearings[0]->sensor_pose.x(), 0.1, 1e-9);
  ASSERT_EQ(content.bearings[0]->detections.size(), 7u);
  EXPECT_NEAR(content.bearings[0]->detections.front().bearing, degToRad(-140), degToRad(0.12));
}

TEST(ImagesApp, TellsTheVerdictOfARunThatTheImagesDisagree)
{
  const ScratchFolder folder;
  const fs::path shown = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/conic-mirror", images = folder.path() / "images";
  fs::copy(shown, images);
  for (const char* const name : {"room_08.jpg", "room_09.jpg", "room_10.jpg"})  // the mirror has been knocked
  {
    const cv::Mat before = cv::imread((shown / name).string());
    cv::Mat after = before.clone();
    before(cv::Rect(14, 0, before.cols - 14, before.rows)).copyTo(after(cv::Rect(0, 0, before.cols - 14, before.rows)));
    cv::imwrite((images / name).string(), after);
  }
  const auto log = testing::logFiles(folder.path(), "log");
  const auto outcome = runOn(images, log.rawlog);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("\nthe images disagree in 3 of 12 frames: expected"), std::string::npos) << outcome.err;
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "conic-mirror", log.arguments()));
  EXPECT_NE(summary.at("verdict_reason").get<std::string>().find("; the log warns: the images disagree in 3 of 12"),
            std::string::npos)
      << summary.at("verdict_reason");
}

TEST(ImagesApp, ReportsMistakesInOneLine)
{
  const ScratchFolder folder;
  const fs::path log = folder.path() / "log.rawlog";
  const auto expect = [&](const testing::AppOutcome& outcome, int code, const std::string& text)
  {
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    EXPECT_FALSE(fs::exists(log));
  };
  expect(runOn(folder.path() / "nowhere", log), 1, "not found, expected a folder with frames.csv or a rawlog");
  expect(runOn(folder.path(), log), 1, "frames.csv");
  folder.write("frames.csv", "frame,picture\n0,a.png\n");
  expect(runOn(folder.path(), log), 1, "image");
  folder.write("frames.csv", "frame,image\n");
  expect(runOn(folder.path(), log), 1, "no images in it");
  folder.write("frames.csv", "frame,image,odometry_x_m\n0,a.png,1\n");
  expect(runOn(folder.path(), log), 1, "odometry_y_m");
  folder.write("frames.csv", "frame,image\n0,a.png\n");
  folder.write("camera.json", "{\"camera\": 5}");
  expect(runOn(folder.path(), log), 1, "camera.json: damaged");
  expect(runOn(folder.path(), folder.path() / "log.txt"), 2, "expected -o STEM.rawlog");
  expect(runOn(folder.path(), log, {"--set", "ConicMirror.ring_outer=0.1"}), 1, "camera.json: damaged");
}
}  // namespace mrpt_ext::test_images_app
