#include "mrpt_ext/front_ends/camera_file.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_camera_file
{
namespace
{
using testing::messageOf;
using testing::ScratchFolder;

CameraFile fileOf(const std::string& json)
{
  const ScratchFolder folder;
  return CameraFile::read(folder.write("camera.json", json));
}

Settings settingsOf(const std::string& lines)
{
  return Settings::parse("[Mono]\n" + lines, "mono.ini",
                         KeyTable({{.section = "Mono", .name = "width_px", .type = KeyType::number},
                                   {.section = "Mono", .name = "depth_m", .type = KeyType::number}}));
}
}  // namespace

TEST(CameraFile, AMissingFileStatesNothing)
{
  const CameraFile file = CameraFile::read("/nowhere/camera.json");
  EXPECT_FALSE(file.number("fx"));
  EXPECT_FALSE(file.fieldNumber("fx"));
  EXPECT_FALSE(file.centres());
}

TEST(CameraFile, HasTheNumbersOfTheCameraAndOfTheField)
{
  const CameraFile file = fileOf(R"({"stereo": {"fx": 300.5}, "field": {"depth": 2}})");
  EXPECT_EQ(file.number("fx"), 300.5);
  EXPECT_FALSE(file.number("depth"));
  EXPECT_EQ(file.fieldNumber("depth"), 2.0);
  EXPECT_EQ(CameraFile({{"width", 640.0}}).number("width"), 640.0);
}

TEST(CameraFile, HasTheCentresOfSeveralCameras)
{
  const std::vector<double> expected{1, 2, 3, 4};
  EXPECT_EQ(fileOf(R"({"camera": {"centers": [[1, 2], [3, 4]]}})").centres(), expected);
  EXPECT_EQ(messageOf<InputError>([] { (void)fileOf(R"({"camera": {"centers": [1, 2]}})").centres(); }),
            "camera.json: centers: expected [cx, cy] of each camera");
  EXPECT_EQ(messageOf<InputError>([] { (void)fileOf(R"({"camera": {"centers": [[1, 1e308]]}})").centres(); }),
            "camera.json: centers is beyond any meaning");
}

TEST(CameraFile, DamageIsAnError)
{
  for (const char* const damaged : {"{", "[]", R"({"lens": {}})", R"({"camera": 3})"})
    EXPECT_NE(messageOf<InputError>([&] { (void)fileOf(damaged); }).find("damaged, expected JSON"), std::string::npos);
  EXPECT_EQ(messageOf<InputError>([] { (void)fileOf(R"({"camera": {"fx": "wide"}})").number("fx"); }),
            "camera.json: fx is no number");
}

TEST(CameraNumbers, TheConfigurationWins)
{
  const CameraFile file({{"width", 640.0}, {"height", 480.0}});
  const Settings settings = settingsOf("width_px = 320\n");
  const CameraNumbers numbers(settings, "Mono", file);
  EXPECT_EQ(numbers.optional("width_px", "width"), 320.0);
  EXPECT_EQ(numbers.required("depth_m", "height"), 480.0);
  EXPECT_FALSE(numbers.optional("depth_m", "depth"));
}

TEST(CameraNumbers, MissingOnesAreNamed)
{
  const CameraFile file({{"width", 0.0}});
  const Settings settings = settingsOf("");
  const CameraNumbers numbers(settings, "Mono", file);
  const std::string missing = "mono.ini: [Mono] depth_m is missing, expected it here or as depth in camera.json";
  EXPECT_EQ(messageOf<InputError>([&] { (void)numbers.required("depth_m", "depth"); }), missing);
  EXPECT_EQ(messageOf<InputError>([&] { (void)numbers.fieldSize("depth_m", "depth"); }), missing);
  EXPECT_EQ(messageOf<InputError>([&] { (void)numbers.size("width_px", "width"); }),
            "camera.json: width is not above zero");
}

TEST(CameraFile, ItsTextWithOtherNumbersKeepsAllElse)
{
  const ScratchFolder folder;
  const CameraFile before = fileOf(R"({"camera": {"fx": 300.5, "cx": 10}, "field": {"depth": 2}})");
  const CameraFile after =
      CameraFile::read(folder.write("camera.json", before.textWith({{"cx", 12.5}, {"camera_tilt_u_deg", -1}})));
  EXPECT_EQ(after.number("fx"), 300.5);
  EXPECT_EQ(after.number("cx"), 12.5);
  EXPECT_EQ(after.number("camera_tilt_u_deg"), -1);
  EXPECT_EQ(after.fieldNumber("depth"), 2);
  EXPECT_EQ(CameraFile::read(folder.write("new.json", CameraFile().textWith({{"cy", 3}}))).number("cy"), 3);
}
}  // namespace mrpt_ext::test_camera_file
