#include "mrpt_ext/files/landmark_map_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error_message.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_landmark_map_file
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
  const auto expectMessage = [&](const char* name, const std::string& text, const std::string& part)
  {
    const auto path = folder.write(name, text);
    const std::string message = testing::messageOf<InputError>([&] { (void)readLandmarkMapFile(path); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expectMessage("a.json", "{\"tags\": [{\"ID\": 1}]}", "a.json: no WPILib field layout");
  expectMessage("a.json", std::string(kWpilib).substr(0, 50), "a.json: no WPILib field layout");
  expectMessage("a.json", "{\"tags\": []}", "a.json: holds no tag");
  expectMessage("a.yaml", "a: [1", "a.yaml:");
  expectMessage("a.yaml", "standalone_tags: []", "a.yaml: 0 tag_bundles, expected one");
  expectMessage("a.yaml", "tag_bundles: [{layout: [{id: 1, x: 0}, {id: 1, x: 2}]}]", "a.yaml: tag 1 is");
  expectMessage("a.yaml", "tag_bundles: [{layout: [{id: one}]}]", "a.yaml:1: no tags.yaml");
}

TEST(LandmarkMapFile, HoldsNoMoreThanTheLimit)
{
  const testing::ScratchFolder folder;
  const auto path = folder.write("tags.yaml", kBundle);
  EXPECT_EQ(readLandmarkMapFile(path, {.rows = 2}).size(), 2U);
  const std::string message =
      testing::messageOf<InputError>([&] { (void)readLandmarkMapFile(path, {.rows = 1, .set_by = "the key"}); });
  EXPECT_TRUE(message.ends_with("tags.yaml: more than 1 tags, expected no more: set the key")) << message;
}

TEST(LandmarkMapFile, AnyOtherNameIsACsv)
{
  const testing::ScratchFolder folder;
  EXPECT_EQ(readLandmarkMapFile(folder.write("map.txt", "id,x,y\n3,1,2\n"))[0].id, 3);
}

TEST(LandmarkMapFile, TagsOfAFieldLayoutFaceAlongTheirXAxis)
{
  // Tags of a field: one on the far wall, turned by half a turn, faces the origin; one on the near wall faces away from
  // it.
  const LandmarkTable map = parseFieldLayout(kWpilib, "field", {});
  EXPECT_NEAR(*map[0].yaw, 2 * std::atan2(0.87, 0.5), 1e-12);
  EXPECT_NEAR(*map[1].yaw, 0, 1e-12);
  const auto yawIn = [](const std::string& rotation)
  {
    return parseFieldLayout(
               R"({"tags": [{"ID": 1, "pose": {"translation": {"x": 16, "y": 1, "z": 1})" + rotation + "}}]}", "field",
               {})[0]
        .yaw;
  };
  const auto turned = [&](const std::string& w, const std::string& x, const std::string& y, const std::string& z)
  {
    return yawIn(R"(, "rotation": {"quaternion": {"W": )" + w + R"(, "X": )" + x + R"(, "Y": )" + y + R"(, "Z": )" + z +
                 "}}");
  };
  EXPECT_NEAR(std::abs(turned("0", "0", "0", "1").value()), kPi, 1e-12);
  // Leaning back by 30 deg, facing the origin: half a turn about z, then a turn about its own y axis.
  EXPECT_NEAR(std::abs(turned("0", "0.258819", "0", "0.965926").value()), kPi, 1e-6);
  EXPECT_FALSE(turned("0.7071068", "0", "-0.7071068", "0"));  // faces the ceiling
  EXPECT_FALSE(turned("0", "0", "0", "0"));
  EXPECT_FALSE(yawIn(""));
}

TEST(LandmarkMapFile, TagsOfABundleFaceAlongTheirZAxis)
{
  const auto yawOf = [](const std::string& quaternion)
  {
    const LandmarkTable map =
        parseTagBundle("tag_bundles: [{name: a, layout: [{id: 1, x: 0, y: 0, z: 1" + quaternion + "}]}]", "a", {});
    return map[0].yaw;
  };
  EXPECT_FALSE(yawOf(""));  // flat on the floor, seen from above
  EXPECT_FALSE(yawOf(", qw: 1, qx: 0, qy: 0, qz: 0"));
  // x to the right of those who stand before it, y up, z towards them: this one hangs upright and faces -y.
  EXPECT_NEAR(*yawOf(", qw: 0.7071068, qx: 0.7071068, qy: 0, qz: 0"), -kPi / 2, 1e-12);
  // ... and this one along x: x axis along y, y axis up.
  EXPECT_NEAR(*yawOf(", qw: 0.5, qx: 0.5, qy: 0.5, qz: 0.5"), 0, 1e-12);
}
}  // namespace mrpt_ext::test_landmark_map_file
