#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "movis_run.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/observations/timestamps.h"
#include "scratch_folder.h"

// What images2rawlog makes of images of the three omnidirectional cameras in other light, of unusable ones and of
// mistakes in the configuration.
namespace mrpt_ext::test_movis_images
{
namespace
{
namespace fs = std::filesystem;
using testing::kOwnScene;
using testing::measure;
using testing::ScratchFolder;

/// The scene in other light and with twice the noise, in `folder`: the channels times 1.15/1.0/0.8, times 0.7, and
/// noise that doubles the total.
void spoil(const fs::path& scene, const fs::path& folder)
{
  for (const auto& entry : fs::directory_iterator(scene))
    if (const std::string kind = entry.path().extension().string(); kind == ".csv" || kind == ".json")
      fs::copy_file(entry.path(), folder / entry.path().filename());
  const auto noise = nlohmann::json::parse(readTextFile(scene / "camera.json"))["noise"];
  const double read = noise["read"], shot = noise["shot"];
  cv::RNG random(1);
  for (const auto& entry : fs::directory_iterator(scene))
  {
    if (entry.path().extension() != ".jpg") continue;
    cv::Mat image;
    cv::imread(entry.path().string()).convertTo(image, CV_32FC3, 0.7);
    cv::multiply(image, cv::Scalar(0.8, 1.0, 1.15), image);
    for (int row = 0; row < image.rows; ++row)
      for (int column = 0; column < image.cols; ++column)
        for (int c = 0; c < 3; ++c)
        {
          float& v = image.at<cv::Vec3f>(row, column)[c];
          v += static_cast<float>(random.gaussian(std::sqrt(3 * (read * read + shot * shot * v / 255))));
        }
    image.convertTo(image, CV_8UC3);
    cv::imwrite((folder / entry.path().filename()).string(), image, {cv::IMWRITE_JPEG_QUALITY, 95});
  }
}

std::size_t detectionsIn(const fs::path& scene)
{
  const ScratchFolder folder;
  return TextTable(measure(scene, folder.path()).csv, {}).size();
}

void expectDetectionsStay(const fs::path& scene)
{
  const ScratchFolder spoiled;
  spoil(scene, spoiled.path());
  const std::size_t before = detectionsIn(scene), after = detectionsIn(spoiled.path());
  EXPECT_GE(static_cast<double>(after), 0.9 * static_cast<double>(before)) << after << " of " << before;
}
}  // namespace

TEST(MovisImages, OwnImagesKeepTheirDetectionsInOtherLight) { expectDetectionsStay(kOwnScene); }

TEST(MovisImages, SharedImagesKeepTheirDetectionsInOtherLight)
{
  for (const char* const name : {"samples/B_paper", "samples/B_paper_yawerr"})
  {
    const auto scene = testing::sharedScene(name);
    if (!scene) GTEST_SKIP() << "the shared scenes are absent";
    expectDetectionsStay(*scene);
  }
}

TEST(MovisImages, UnusableImagesAreReportedAndCounted)
{
  const ScratchFolder folder;
  fs::copy_file(kOwnScene / "camera.json", folder.path() / "camera.json");
  fs::copy_file(kOwnScene / "field_00_M1.jpg", folder.path() / "a_M1.jpg");
  cv::imwrite((folder.path() / "black.png").string(), cv::Mat::zeros(320, 320, CV_8UC3));
  folder.write("torn.png", "no image at all");
  folder.write("frames.csv", "frame,M1,M2,M3\n0,a_M1.jpg,black.png,torn.png\n1,,absent.png,black.png\n");
  const fs::path log = folder.path() / "log.rawlog";
  const auto outcome = testing::runImages(
      {testing::shipped("images2rawlog", "movis").string(), "-i", folder.path().string(), "-o", log.string()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err,
            "black.png: no mirror found, no measurement\ntorn.png: image is missing, empty or damaged, no measurement\n"
            "frame 1 M1: image is missing, empty or damaged, no measurement\nabsent.png: image is missing, empty or "
            "damaged, no measurement\n"
            "black.png: no mirror found, no measurement\n");
  EXPECT_NE(outcome.out.find("2 frames, 3 measurements, 1 frames without measurement"), std::string::npos)
      << outcome.out;
}

TEST(MovisImages, CamerasOfARawlogAreFoundByTheirLabels)
{
  const ScratchFolder folder;
  const fs::path input = folder.path() / "images.rawlog";
  {
    mrpt::io::CFileGZOutputStream file(input.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    for (const char* const label : {"M1", "M2", "front"})
    {
      const std::string name = std::string("field_00_") + (label[0] == 'M' ? label : "M3") + ".jpg";
      auto image = mrpt::obs::CObservationImage::Create();
      image->timestamp = timestampOf(100);
      image->sensorLabel = label;
      image->image = mrpt::img::CImage(cv::imread((kOwnScene / name).string()), mrpt::img::DEEP_COPY);
      archive << *image;
    }
  }
  // A rawlog has no camera.json beside it: the camera is in the .ini.
  std::vector<std::string> arguments{testing::shipped("images2rawlog", "movis").string(),
                                     "-i",
                                     input.string(),
                                     "-o",
                                     (folder.path() / "log.rawlog").string(),
                                     "--csv",
                                     (folder.path() / "log.csv").string()};
  for (const char* const setting :
       {"mount_radius_m=0.22", "mirror_a_m=0.03", "mirror_b_m=0.024", "mirror_rim_radius_m=0.031",
        "mirror_focus_height_m=0.62", "focal_length_x_px=423", "focal_length_y_px=423",
        "centres=160.4 158.7 158.9 160.2 159.8 159.1", "field_half_width_m=2.5", "field_depth_m=4", "pole_radius_m=0.1",
        "pole_height_m=1", "ball_radius_m=0.11"})
    for (const std::string& word : {std::string("--set"), std::string("Movis.") + setting}) arguments.push_back(word);
  const auto outcome = testing::runImages(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "frame 2: no image of M1, M2 or M3, no measurement\n");
  const TextTable table(folder.path() / "log.csv", {});
  ASSERT_EQ(table.size(), 6u);
  EXPECT_EQ(table.text(0, table.column("sensor")), "M1");
  EXPECT_EQ(table.text(5, table.column("sensor")), "M2");
}

TEST(MovisImages, ReportsMistakesInOneLine)
{
  const ScratchFolder folder;
  const auto expect = [&](const testing::Arguments& more, int code, const std::string& text)
  {
    const fs::path log = folder.path() / "log.rawlog";
    const auto outcome = testing::runImages(testing::joined(
        {testing::shipped("images2rawlog", "movis").string(), "-i", kOwnScene.string(), "-o", log.string()}, more));
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    EXPECT_FALSE(fs::exists(log));
  };
  expect({"--set", "Movis.calibration_frame=99"}, 2, "calibration_frame");
  expect({"--set", "Movis.pole_ids=1 1"}, 2, "expected two different ids");
  expect({"--set", "Movis.yellow_hue_deg=80 33"}, 2, "expected the smaller hue first");
  expect({"--set", "Movis.centres=1 2 3"}, 2, "expected cx cy of M1, M2 and M3");
  fs::copy_file(kOwnScene / "frames.csv", folder.path() / "frames.csv");
  folder.write("camera.json", R"({"camera": {"width": 320}})");
  const auto outcome = testing::runImages({testing::shipped("images2rawlog", "movis").string(), "-i",
                                           folder.path().string(), "-o", (folder.path() / "log.rawlog").string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("mount_radius_m is missing, expected it here or as L in camera.json"), std::string::npos)
      << outcome.err;
}
}  // namespace mrpt_ext::test_movis_images
