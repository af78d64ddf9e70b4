#include "mrpt_ext/importers/rosbag2/message_definition.h"

#include <gtest/gtest.h>

#include "mrpt_ext/importers/rosbag2/byte_reader.h"
#include "mrpt_ext/importers/rosbag2/well_known_definitions.h"

namespace mrpt_ext::test_message_definition
{
TEST(MessageDefinition, FindsStructuresOfItsPackageAndOfOthers)
{
  const MessageDefinition definition = parseMessageDefinition(
      "a/msg/Root",
      "Header h\r\nNear near\nb/Far far\n===\nMSG: std_msgs/Header\nuint8 x\n===\nMSG: a/Near\nuint8 x\n===\n"
      "MSG: b/msg/Far\nuint8 x\n");
  ASSERT_GE(definition.types.size(), 4U);
  const auto& fields = definition.types[0].fields;
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(definition.types[fields[0].structure].name, "std_msgs/Header");
  EXPECT_EQ(definition.types[fields[1].structure].name, "a/Near");
  EXPECT_EQ(definition.types[fields[2].structure].name, "b/Far");
}

TEST(MessageDefinition, RefusesWhatCannotBe)
{
  const auto parse = [](const std::string& text) { return parseMessageDefinition("a/msg/Root", text); };
  EXPECT_THROW(parse("Missing x\n"), DamagedBytes);
  EXPECT_THROW(parse("Root x\n"), DamagedBytes);
  EXPECT_THROW(parse("Other x\n===\nMSG: a/Other\nRoot y\n"), DamagedBytes);
  EXPECT_THROW(parse("uint8[0] x\n"), DamagedBytes);
  EXPECT_THROW(parse("uint8[x] x\n"), DamagedBytes);
  EXPECT_THROW(parse("uint8\n"), DamagedBytes);
  EXPECT_THROW(parse("wstring x\n"), DamagedBytes);
  EXPECT_THROW(parse(std::string(2 << 20, '\n')), DamagedBytes);
}

TEST(MessageDefinition, ManyTypesThatShareOthersTakeNoTime)
{
  std::string text;
  for (int i = 0; i < 500; ++i)
    text += "T" + std::to_string(i) + " a\nT" + std::to_string(i) + " b\n===\nMSG: a/T" + std::to_string(i) + "\n";
  EXPECT_GE(parseMessageDefinition("a/msg/Root", text + "uint8 x\n").types.size(), 501U);
}

TEST(MessageDefinition, TheWellKnownOnesAreComplete)
{
  for (const char* type : {"nav_msgs/msg/Odometry", "tf2_msgs/msg/TFMessage", "geometry_msgs/msg/TransformStamped",
                           "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/PoseWithCovarianceStamped",
                           "geometry_msgs/msg/PointStamped", "apriltag_msgs/msg/AprilTagDetectionArray",
                           "sensor_msgs/msg/CameraInfo", "vision_msgs/msg/Detection3DArray",
                           "sick_scan_xd/msg/NAVLandmarkData", "sensor_msgs/msg/Range", "sensor_msgs/msg/LaserScan"})
  {
    const auto texts = wellKnownDefinitions(type);
    EXPECT_FALSE(texts.empty()) << type;
    for (const std::string& text : texts) EXPECT_NO_THROW(parseMessageDefinition(type, text)) << type;
  }
  EXPECT_TRUE(wellKnownDefinitions("sensor_msgs/msg/Image").empty());
}
}  // namespace mrpt_ext::test_message_definition
