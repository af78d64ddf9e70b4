#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/serialization/CArchive.h>

#include <bitset>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"
#include "mrpt_ext/observations/timestamps.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"
#include "run_images.h"
#include "scratch_folder.h"
#include "tag_picture.h"

// From images with fiducial tags to bearings and ranges (ini/images2rawlog/tags.ini) and poses
// (ini/landmark-localization/tags.ini). The drive through a hall has corners that are moved by 0.5 px each way.
namespace mrpt_ext::test_tags_run
{
namespace
{
namespace fs = std::filesystem;
using testing::PlacedTag;
using testing::ScratchFolder;
using testing::wallCamera;

const fs::path kHall = fs::path(MRPT_EXT_SOURCE_DIR) / "datasets/tags";

testing::AppOutcome measureTags(const fs::path& input, const fs::path& rawlog, const testing::Arguments& more = {})
{
  return testing::runImages(testing::joined(
      {testing::shipped("images2rawlog", "tags").string(), "-i", input.string(), "-o", rawlog.string()}, more));
}

/// The table of images2rawlog beside the truth.
struct TagScore
{
  int in_view = 0, seen = 0, untrue = 0;
  double bearing_nees = 0, range_nees = 0;  ///< means
};

TagScore scoreOf(const fs::path& csv, const fs::path& scene)
{
  struct True
  {
    double range, bearing;
  };
  std::map<std::pair<int, int>, True> truth;
  TagScore score;
  const TextTable shown(scene / "observations.csv", {});
  for (std::size_t row = 0; row < shown.size(); ++row)
  {
    truth[{shown.integer(row, shown.column("frame")), shown.integer(row, shown.column("id"))}] = {
        shown.number(row, shown.column("range_m")), shown.number(row, shown.column("bearing_deg"))};
    score.in_view += shown.integer(row, shown.column("in_view"));
  }
  const TextTable table(csv, {});
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto number = [&](const char* column) { return table.number(row, table.column(column)); };
    const auto at = truth.find({table.integer(row, table.column("frame")), table.integer(row, table.column("label"))});
    ++(at == truth.end() ? score.untrue : score.seen);
    if (at == truth.end()) continue;
    score.bearing_nees += square((number("azimuth_deg") - at->second.bearing) / number("std_azimuth_deg"));
    score.range_nees += square((number("range_m") - at->second.range) / number("std_range_m"));
  }
  score.bearing_nees /= score.seen, score.range_nees /= score.seen;
  return score;
}

constexpr const char* kWallCamera =
    R"({"camera": {"width": 640, "height": 480, "fx": 440, "fy": 440, "cx": 319.5, "cy": 239.5, "forward": 0.1,
 "left": -0.05, "height_m": 0.4, "mount_yaw_deg": 10, "pitch_deg": -9, "tag_edge_m": 0.2}})";

cv::Mat oneTag(int id)
{
  return testing::paintTags({640, 480}, arucoOriginal(), {{id, PlacedTag{.bearing = 0.2}.corners(wallCamera())}});
}

const testing::Arguments kOriginalAruco{"--set", "Tags.family=aruco_original"};

std::vector<CObservationStereoRanges::Ptr> tagsIn(const fs::path& rawlog)
{
  std::vector<CObservationStereoRanges::Ptr> found;
  RawlogReader reader(rawlog);
  while (const auto record = reader.next())
    if (const auto seen = std::dynamic_pointer_cast<CObservationStereoRanges>(record)) found.push_back(seen);
  return found;
}

void expectTheTag(const CObservationStereoRanges& seen, int id)
{
  EXPECT_EQ(seen.sensorLabel, "tags");
  EXPECT_TRUE(seen.horizontal);
  EXPECT_NEAR(seen.sensor_pose.x(), 0.1, 1e-6);
  EXPECT_NEAR(seen.sensor_pose.y(), -0.05, 1e-6);
  EXPECT_NEAR(seen.sensor_pose.z(), 0.4, 1e-6);
  EXPECT_NEAR(seen.sensor_pose.yaw(), degToRad(10), 1e-6);
  ASSERT_EQ(seen.detections.size(), 1U);
  EXPECT_EQ(seen.detections[0].id, id);
  EXPECT_NEAR(*seen.detections[0].range, 2, 0.02);
  EXPECT_NEAR(*seen.detections[0].bearing, 0.2, 5e-4);
}
}  // namespace

TEST(TagsRun, TheHallGivesTagsWithHonestDeviations)
{
  const ScratchFolder folder;
  const fs::path csv = folder.path() / "tags.csv";
  const auto outcome = measureTags(kHall, folder.path() / "tags.rawlog",
                                   {"--csv", csv.string(), "--debug-images", (folder.path() / "seen").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const TagScore score = scoreOf(csv, kHall);
  EXPECT_EQ(score.untrue, 0);
  EXPECT_GE(score.seen, 0.85 * score.in_view);
  EXPECT_GT(std::min(score.bearing_nees, score.range_nees), 0.7);
  EXPECT_LT(std::max(score.bearing_nees, score.range_nees), 1.45);  // 103 measurements: 1 with a deviation of 0.14
  EXPECT_TRUE(fs::exists(folder.path() / "seen/hall_00.png"));
}

TEST(TagsRun, TheHallGivesPosesNearTheBound)
{
  const ScratchFolder folder;
  const auto files = testing::logFiles(folder.path(), "tags");
  ASSERT_EQ(measureTags(kHall, files.rawlog).exit_code, 0);
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "tags", files.arguments()));
  EXPECT_EQ(summary.at("verdict"), "ok");
  EXPECT_LT(testing::positionRmse(summary), 1.2 * summary.at("limit").at("pcrlb_position_rmse_m").get<double>());
}

TEST(TagsRun, AFieldLayoutIsAMapOfTheTags)
{
  const ScratchFolder folder;
  const auto files = testing::logFiles(folder.path(), "tags");
  ASSERT_EQ(measureTags(kHall, files.rawlog).exit_code, 0);
  const TextTable map(kHall / "map.csv", {});
  nlohmann::json layout = {{"tags", nlohmann::json::array()}};
  for (std::size_t row = 0; row < map.size(); ++row)
    layout["tags"].push_back(
        {{"ID", map.integer(row, map.column("id"))},
         {"pose",
          {{"translation",
            {{"x", map.number(row, map.column("x_m"))}, {"y", map.number(row, map.column("y_m"))}, {"z", 1.0}}}}}});
  const fs::path field = folder.write("field.json", layout.dump());
  const auto summary = testing::summaryOf(testing::localized(
      folder.path(), "tags", {files.rawlog.string(), "--map", field.string(), "--ground-truth", files.truth.string()}));
  EXPECT_EQ(summary.at("verdict"), "ok");
  EXPECT_LT(testing::positionRmse(summary), 0.05);
}

TEST(TagsRun, CornersWorseThanStatedWidenTheDeviations)
{
  const ScratchFolder folder;
  const auto stated = [&](const testing::Arguments& more)
  {
    return measureTags(kHall, folder.path() / "log.rawlog",
                       testing::joined({"--set", "Tags.std_corner_px=0.1", "--set", "Tags.gate=100"}, more));
  };
  const std::string said = stated({}).out;
  EXPECT_NE(said.find("px about squares, more than std_corner_px states; taken instead"), std::string::npos) << said;
  const double std_corner = std::stod(said.substr(said.find("scatter by ") + 11));
  EXPECT_NEAR(std_corner, 0.5, 0.1);
  EXPECT_EQ(stated({"--set", "Tags.corner_noise_frames=0"}).out.find("scatter"), std::string::npos);
}

TEST(TagsRun, AFolderWithItsCamera)
{
  const ScratchFolder folder;
  cv::imwrite((folder.path() / "a.png").string(), oneTag(33));
  cv::imwrite((folder.path() / "black.png").string(), cv::Mat::zeros(480, 640, CV_8U));
  folder.write("camera.json", kWallCamera);
  folder.write("frames.csv", "frame,image\n0,a.png\n1,black.png\n2,absent.png\n");
  const fs::path rawlog = folder.path() / "log.rawlog", csv = folder.path() / "log.csv";
  const auto outcome = measureTags(folder.path(), rawlog, testing::joined(kOriginalAruco, {"--csv", csv.string()}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "black.png: image is black or of one colour, no measurement\n"
            "absent.png: image is missing, empty or damaged, no measurement\n");
  const auto seen = tagsIn(rawlog);
  ASSERT_EQ(seen.size(), 1U);
  expectTheTag(*seen[0], 33);
  const TextTable table(csv, {});
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table.text(0, table.column("label")), "33");
  EXPECT_NEAR(table.number(0, table.column("azimuth_deg")), 10 + radToDeg(0.2), 0.03);
}

TEST(TagsRun, ARawlogWithItsCamera)
{
  const ScratchFolder folder;
  const fs::path input = folder.path() / "images.rawlog";
  {
    mrpt::io::CFileGZOutputStream file(input.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    auto image = mrpt::obs::CObservationImage::Create();
    image->timestamp = timestampOf(100);
    image->sensorLabel = "front";
    image->image = mrpt::img::CImage(oneTag(71), mrpt::img::DEEP_COPY);
    image->cameraParams.ncols = 640, image->cameraParams.nrows = 480;
    image->cameraParams.setIntrinsicParamsFromValues(440, 440, 319.5, 239.5);
    image->cameraPose = mrpt::poses::CPose3D(0.1, -0.05, 0.4, degToRad(10 - 90), 0, degToRad(-90 + 9));
    archive << *image;
  }
  const fs::path rawlog = folder.path() / "log.rawlog";
  const auto outcome = measureTags(input, rawlog, testing::joined(kOriginalAruco, {"--set", "Tags.tag_edge_m=0.2"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto seen = tagsIn(rawlog);
  ASSERT_EQ(seen.size(), 1U);
  expectTheTag(*seen[0], 71);
}

TEST(TagsRun, TagsOfADictionaryFile)
{
  const ScratchFolder folder;
  cv::imwrite((folder.path() / "a.png").string(), oneTag(1));
  std::string dictionary = "%YAML:1.0\n---\nnmarkers: 2\nmarkersize: 5\n";
  for (const int id : {0, 1})
    dictionary +=
        "marker_" + std::to_string(id) + ": \"" + std::bitset<25>(arucoOriginal().codes[id]).to_string() + "\"\n";
  const fs::path file = folder.write("tags.yml", dictionary);
  folder.write("camera.json", kWallCamera);
  folder.write("frames.csv", "frame,image\n0,a.png\n");
  const fs::path rawlog = folder.path() / "log.rawlog";
  const auto outcome = measureTags(folder.path(), rawlog, {"--set", "Tags.dictionary_file=" + file.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  ASSERT_EQ(tagsIn(rawlog).size(), 1U);
  expectTheTag(*tagsIn(rawlog)[0], 1);
}

TEST(TagsRun, MissingValuesAreOneLine)
{
  const ScratchFolder folder;
  const auto expect = [&](const std::string& text, const testing::Arguments& more = {})
  {
    const auto outcome = measureTags(folder.path(), folder.path() / "log.rawlog", more);
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  };
  folder.write("frames.csv", "frame,image\n0,a.png\n");
  expect("[Tags] focal_u_px is missing, expected it here or as fx in camera.json");
  folder.write("camera.json", R"({"camera": {"fx": 440, "fy": 440, "cx": 319.5, "cy": 239.5}})");
  expect("[Tags] tag_edge_m is missing, expected it here or as tag_edge_m in camera.json");
  expect("no such file", {"--set", "Tags.tag_edge_m=0.2", "--set", "Tags.dictionary_file=absent.yml"});
  expect("family", {"--set", "Tags.family=tag99h99"});
}
}  // namespace mrpt_ext::test_tags_run
