#include "mrpt_ext/importers/rosbag2/message_value.h"

#include <gtest/gtest.h>

#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext::test_message_value
{
namespace
{
using namespace std::string_literals;

const std::string kHeader = "\0\1\0\0"s;

MessageValue decoded(const std::string& definition, const std::string& body)
{
  static MessageDefinition kept;
  kept = parseMessageDefinition("pkg/msg/Root", definition);
  return decodeMessage(kept, kHeader + body);
}
}  // namespace

TEST(MessageValue, HasTheFieldsOfTheDefinition)
{
  const MessageValue value = decoded(
      "# a comment\nuint8 KIND = 3\nstring<=5 DEFAULT='a=b' # constant\nint16 a -7\nInner[2] inner\nuint8[] "
      "bytes\nstring[<=3] names\n"
      "===\nMSG: pkg/Inner\nbool on\nint8 depth\n",
      "\xF9\xFF\1\xFF\0\2\0\0\2\0\0\0\5\6\0\0\1\0\0\0\3\0\0\0hi\0"s);
  EXPECT_EQ(value.number("a"), -7);
  ASSERT_EQ(value.list("inner").size(), 2U);
  EXPECT_EQ(value.list("inner")[0].number("depth"), -1);
  EXPECT_EQ(value.list("inner")[1].number("on"), 0);
  EXPECT_EQ(value.numbers("bytes"), (std::vector<double>{5, 6}));
  ASSERT_EQ(value.list("names").size(), 1U);
  EXPECT_EQ(value.list("names")[0].text(""), "hi");
  EXPECT_EQ(value.find("KIND"), nullptr);
  EXPECT_EQ(value.find("DEFAULT"), nullptr);
}

TEST(MessageValue, RefusesFieldsThatAreNotThere)
{
  const MessageValue value = decoded("uint8 a\nstring b\n", "\1\0\0\0\1\0\0\0\0"s);
  EXPECT_THROW(static_cast<void>(value.number("c")), DamagedBytes);
  EXPECT_THROW(static_cast<void>(value.number("a.x")), DamagedBytes);
  EXPECT_THROW(static_cast<void>(value.number("b")), DamagedBytes);
  EXPECT_THROW(static_cast<void>(value.list("a")), DamagedBytes);
}

TEST(MessageValue, RefusesMessagesThatDoNotFit)
{
  EXPECT_THROW(decoded("uint32 a\n", "\1\0"s), DamagedBytes);
  EXPECT_THROW(decoded("uint8 a\n", std::string(20, '\0')), DamagedBytes);
  EXPECT_THROW(decoded("float64[4000000000] a\n", std::string(20, '\0')), DamagedBytes);
  EXPECT_THROW(decoded("uint8[] a\n", "\xFF\xFF\xFF\xFF\1"s), DamagedBytes);
  const std::string many(5'000'000, '\0');
  EXPECT_THROW(decoded("uint8[5000000] a\n", many), DamagedBytes);
}

TEST(MessageValue, AnEmptyStructureTakesOneByte)
{
  const MessageValue value = decoded("Nothing[] a\nuint8 b\n===\nMSG: pkg/Nothing\n", "\2\0\0\0\0\0\11"s);
  EXPECT_EQ(value.list("a").size(), 2U);
  EXPECT_EQ(value.number("b"), 9);
}
}  // namespace mrpt_ext::test_message_value
