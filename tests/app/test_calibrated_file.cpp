#include "mrpt_ext/app/calibrated_file.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_calibrated_file
{
using testing::messageOf;
using testing::ScratchFolder;

TEST(CalibratedFile, IsAConfiguration)
{
  const ScratchFolder folder;
  const std::string text = "[Sensor_eye]\nstd_bearing_deg = 1\n";
  EXPECT_EQ(readFileToCalibrate(folder.write("my.ini", text)), text);
}

TEST(CalibratedFile, NothingElseIsWrittenInto)
{
  const ScratchFolder folder;
  const auto message = [&](const std::string& name, const std::string& content)
  { return messageOf<InputError>([&] { (void)readFileToCalibrate(folder.write(name, content)); }); };
  const std::string only = ": only a configuration (.ini) of landmark-localization is written into (";
  EXPECT_NE(message("a.rawlog", std::string("\x1f\x8b\x08\0\0", 5)).find("a.rawlog" + only), std::string::npos);
  EXPECT_NE(message("map.csv", "id,x,y\n1,2,3\n").find("map.csv" + only), std::string::npos);
  EXPECT_NE(message("other.ini", "[Simulation]\nduration_s = 10\n").find("unknown section"), std::string::npos);
  EXPECT_NE(messageOf<InputError>([&] { (void)readFileToCalibrate(folder.path() / "none.ini"); }).find("no such file"),
            std::string::npos);
}

TEST(CalibratedFile, MayBeginAsTheBuiltInConfiguration)
{
  const ScratchFolder folder;
  EXPECT_EQ(readFileToCalibrate(folder.path() / "new.ini", "[Sensor_eye]\n"), "[Sensor_eye]\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "new.ini"));
  EXPECT_EQ(readFileToCalibrate(folder.write("my.ini", "[Sensor_ear]\n"), "[Sensor_eye]\n"), "[Sensor_ear]\n");
  const auto nowhere = folder.path() / "nowhere" / "new.ini";
  EXPECT_EQ(messageOf<InputError>([&] { (void)readFileToCalibrate(nowhere, "[Sensor_eye]\n"); }),
            "--calibrate " + nowhere.string() + ": no such folder");
}
}  // namespace mrpt_ext::test_calibrated_file
