#include "mrpt_ext/configuration/configured_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "error_message.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_configured_files
{
namespace
{
/// [LocalizationExperiment] with `lines`, beside a map of two landmarks.
Settings settingsWith(const std::filesystem::path& folder, const std::string& lines)
{
  std::ofstream(folder / "map.csv") << "id,x,y,z,category\n4,1,2,0.5,\n7,-3,4,0,\n";
  return Settings::parse(
      "[LocalizationExperiment]\n" + lines + "\n[MetricMap_landmarkMap2D_00_creationOpts]\nlandmarks_file = map.csv\n",
      folder / "a.ini", localizationKeys());
}
}  // namespace

TEST(ConfiguredMap, HasItsLandmarksWhereTheConfigurationCorrectsThemToBe)
{
  const testing::ScratchFolder folder;
  const Settings settings =
      settingsWith(folder.path(), "landmark_shift_x_m = 7:0.25\nlandmark_shift_y_m = 7:-0.5 4:0.125");
  const LandmarkTable map = configuredMap(settings);
  ASSERT_EQ(map.size(), 2U);
  EXPECT_EQ(map[0].position, Vector3d(1, 2.125, 0.5));
  EXPECT_EQ(map[1].position, Vector3d(-2.75, 3.5, 0));
  EXPECT_EQ(correctedMap(settings, map)[1].position, Vector3d(-2.5, 3, 0));
  const LocalizationConfig config = localizationConfig(settings, map);
  EXPECT_EQ(config.landmark_shift_x, (LandmarkValues{{7, 0.25}}));
  EXPECT_EQ(config.landmark_shift_y, (LandmarkValues{{4, 0.125}, {7, -0.5}}));
}

TEST(ConfiguredMap, OfALandmarkThatIsNotThereIsAnErrorWithItsLine)
{
  const testing::ScratchFolder folder;
  const std::string error = testing::messageOf<InputError>(
      [&] { (void)configuredMap(settingsWith(folder.path(), "random_seed = 2\nlandmark_shift_y_m = 5:0.1")); });
  EXPECT_NE(error.find("a.ini:3: landmark_shift_y_m = 5:0.1: landmark 5 is not in the map"), std::string::npos)
      << error;
}
}  // namespace mrpt_ext::test_configured_files
