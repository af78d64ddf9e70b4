#include "mrpt_ext/importers/landmark_map_file.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/csv_recording.h"
#include "sample_data.h"

namespace mrpt_ext
{
namespace
{
// Two tags in the form of WPILib's field layouts.
const char* const kWpilib = R"({"tags": [
  {"ID": 1, "pose": {"translation": {"x": 15.08, "y": 0.25, "z": 1.36},
                     "rotation": {"quaternion": {"W": 0.5, "X": 0, "Y": 0, "Z": 0.87}}}},
  {"ID": 7, "pose": {"translation": {"x": -0.04, "y": 5.55, "z": 1.45},
                     "rotation": {"quaternion": {"W": 1, "X": 0, "Y": 0, "Z": 0}}}}],
  "field": {"length": 16.54, "width": 8.21}})";

const char* const kBundle = R"(standalone_tags:
  [{id: 99, size: 0.1}]
tag_bundles:
  [
    {
      name: 'hall',
      layout:
        [
          {id: 3, size: 0.2, x: 1.5, y: -2, z: 0.5, qw: 1, qx: 0, qy: 0, qz: 0},
          {id: 4, size: 0.2, x: 0, y: 0, z: 0}
        ]
    }
  ]
)";
}  // namespace

TEST(LandmarkMapFile, WpilibFieldLayout)
{
  const testing::ScratchFolder folder;
  const LandmarkTable map = readLandmarkMapFile(folder.write("field.json", kWpilib));
  ASSERT_EQ(map.size(), 2U);
  EXPECT_EQ(map[0].id, 1);
  EXPECT_EQ(map[0].position, Vector3d(15.08, 0.25, 1.36));
  EXPECT_EQ(map[1].category, "tag");
}

TEST(LandmarkMapFile, BundleOfApriltagRos)
{
  const testing::ScratchFolder folder;
  const LandmarkTable map = readLandmarkMapFile(folder.write("tags.yaml", kBundle));
  ASSERT_EQ(map.size(), 2U);
  EXPECT_EQ(map[0].id, 3);
  EXPECT_EQ(map[0].position, Vector3d(1.5, -2, 0.5));
}

TEST(LandmarkMapFile, DamageIsNamed)
{
  const testing::ScratchFolder folder;
  const auto read = [&](const char* name, const std::string& text)
  { (void)readLandmarkMapFile(folder.write(name, text)); };
  EXPECT_INPUT_ERROR(read("a.json", "{\"tags\": [{\"ID\": 1}]}"), "a.json: no WPILib field layout");
  EXPECT_INPUT_ERROR(read("a.json", std::string(kWpilib).substr(0, 50)), "a.json: no WPILib field layout");
  EXPECT_INPUT_ERROR(read("a.json", "{\"tags\": []}"), "a.json: holds no tag");
  EXPECT_INPUT_ERROR(read("a.yaml", "a: [1"), "a.yaml:");
  EXPECT_INPUT_ERROR(read("a.yaml", "standalone_tags: []"), "a.yaml: 0 tag_bundles, expected one");
  EXPECT_INPUT_ERROR(read("a.yaml", "tag_bundles: [{layout: [{id: 1, x: 0}, {id: 1, x: 2}]}]"), "a.yaml: tag 1 is");
  EXPECT_INPUT_ERROR(read("a.yaml", "tag_bundles: [{layout: [{id: one}]}]"), "a.yaml:1: no tags.yaml");
}

TEST(LandmarkMapFile, StandsForLandmarksCsv)
{
  const testing::DamagedCopy copy("csv");
  copy.replace("landmarks.json", kWpilib);
  EXPECT_INPUT_ERROR((void)findCsvFiles({copy.path()}), "landmarks.json: a second map beside");
  copy.remove("landmarks.csv");
  EXPECT_EQ(importCsv(findCsvFiles({copy.path()})).map.size(), 2U);
}
}  // namespace mrpt_ext
