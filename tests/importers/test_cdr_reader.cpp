#include "mrpt_ext/importers/rosbag2/cdr_reader.h"

#include <gtest/gtest.h>

#include "bag_samples.h"

namespace mrpt_ext::test_cdr_reader
{
namespace
{
using namespace std::string_literals;

/// geometry_msgs/PoseStamped as @foxglove/cdr writes it.
void expectPose(const std::string& message)
{
  CdrReader reader(message);
  EXPECT_EQ(reader.number<std::int32_t>(), 17);
  EXPECT_EQ(reader.number<std::uint32_t>(), 500000000U);
  EXPECT_EQ(reader.text(), "map");
  for (const double expected : {1.5, -2.5, 0.25, 0.0, 0.0, 0.0, 1.0}) EXPECT_EQ(reader.number<double>(), expected);
  EXPECT_EQ(reader.left(), 0U);
}
}  // namespace

TEST(CdrReader, ReadsBothOrdersOfBytes)
{
  expectPose(readTextFile(testing::bag("pose_little_endian.cdr")));
  expectPose(readTextFile(testing::bag("pose_big_endian.cdr")));
}

TEST(CdrReader, AlignsNumbersToTheirSizeBehindTheHeader)
{
  const std::string message = "\0\1\0\0\7\0\0\0\5\0\0\0"s;
  CdrReader reader(message);
  EXPECT_EQ(reader.number<std::uint8_t>(), 7);
  EXPECT_EQ(reader.number<std::uint32_t>(), 5U);
}

TEST(CdrReader, RefusesWhatGoesBeyondTheMessage)
{
  EXPECT_THROW(CdrReader("\0\1"s), DamagedBytes);
  EXPECT_THROW(static_cast<void>(CdrReader("\0\1\0\0\1"s).number<double>()), DamagedBytes);
  EXPECT_THROW(static_cast<void>(CdrReader("\0\1\0\0\377\377\377\377abc"s).text()), DamagedBytes);
  EXPECT_THROW(static_cast<void>(CdrReader("\0\1\0\0\3\0\0\0ab"s).sequenceLength(1)), DamagedBytes);
}

TEST(CdrReader, RefusesOtherForms) { EXPECT_THROW(CdrReader("\0\7\0\0abcd"s), DamagedBytes); }
}  // namespace mrpt_ext::test_cdr_reader
