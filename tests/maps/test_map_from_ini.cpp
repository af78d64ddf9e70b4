#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "error_message.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/maps/CLandmarkMap2D.h"
#include "mrpt_ext/maps/landmark_file.h"
#include "mrpt_ext/maps/register_all_classes.h"

namespace mrpt_ext::test_map_from_ini
{
namespace
{
class MapFromIni : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    registerAllClasses();
    std::filesystem::create_directories(folder_);
    writeLandmarkCsv(folder_ / "room.csv", LandmarkTable({{.id = 5, .position = {1, 2, 0}}}));
  }
  void TearDown() override
  {
    unsetenv("LANDMARK_MAP_DIR");
    std::filesystem::remove_all(folder_);
  }

  static mrpt::maps::CMultiMetricMap build(const std::string& file, const std::string& more)
  {
    const std::string section = "[MetricMap_landmarkMap2D_00_";
    const mrpt::config::CConfigFileMemory ini("[MetricMap]\nlandmarkMap2D_count = 1\n" + section +
                                              "creationOpts]\nlandmarks_file = " + file + "\n" + section +
                                              "likelihoodOpts]\n" + more);
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    definitions.loadFromConfigFile(ini, "MetricMap");
    mrpt::maps::CMultiMetricMap maps;
    maps.setListOfMaps(definitions);
    return maps;
  }

  static std::string messageOf(const std::string& file, const std::string& more)
  {
    return testing::messageOf<std::exception>([&] { build(file, more); });
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("map_from_ini_" + std::to_string(getpid()));
};
}  // namespace

TEST_F(MapFromIni, IsMadeByItsShortName)
{
  const auto maps = build((folder_ / "room.csv").string(),
                          "clutter_probability = 0.1\ndefault_std_bearing_deg = 3\ndefault_std_range_m = 0.25\n");
  ASSERT_EQ(maps.countMapsByClass<CLandmarkMap2D>(), 1U);
  const auto map = maps.mapByClass<CLandmarkMap2D>();
  EXPECT_EQ(map->landmarks().indexOf(5), 0U);
  EXPECT_EQ(map->likelihood_options.clutter_probability, 0.1);
  EXPECT_NEAR(map->likelihood_options.default_std_bearing, degToRad(3), 1e-12);
  EXPECT_EQ(map->likelihood_options.default_std_range, 0.25);
  EXPECT_EQ(map->likelihood_options.detection_probability, 0);
}

TEST_F(MapFromIni, LooksForTheFileInTheNamedFolderToo)
{
  EXPECT_NE(messageOf("room.csv", "").find("landmarks_file = room.csv"), std::string::npos);
  setenv("LANDMARK_MAP_DIR", folder_.c_str(), 1);
  EXPECT_EQ(build("room.csv", "").countMapsByClass<CLandmarkMap2D>(), 1U);
  EXPECT_EQ(findLandmarkFile("room.csv"), folder_ / "room.csv");
}

TEST_F(MapFromIni, RefusesMistakes)
{
  const std::string file = (folder_ / "room.csv").string();
  EXPECT_NE(messageOf("", "").find("landmarks_file"), std::string::npos);
  EXPECT_NE(messageOf(file, "clutter = 0.1\n").find("clutter: unknown key"), std::string::npos);
  EXPECT_NE(messageOf(file, "clutter_probability = nine\n").find("found 'nine'"), std::string::npos);
  EXPECT_NE(messageOf(file, "clutter_probability = 2\n").find("found '2'"), std::string::npos);
  EXPECT_NE(messageOf(file, "default_std_range_m = -1\n").find("default_std_range_m"), std::string::npos);
}
}  // namespace mrpt_ext::test_map_from_ini
