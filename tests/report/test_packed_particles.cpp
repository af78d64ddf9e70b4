#include "mrpt_ext/report/packed_particles.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::test_packed_particles
{
namespace
{
unsigned byteAt(const PackedPoses& packed, std::size_t i) { return static_cast<unsigned char>(packed.bytes[i]); }

/// As the page reads them.
Pose2 unpacked(const PackedPoses& packed, std::size_t i)
{
  const unsigned x = byteAt(packed, 4 * i) << 4U | byteAt(packed, 4 * i + 1) >> 4U;
  const unsigned y = (byteAt(packed, 4 * i + 1) & 15U) << 8U | byteAt(packed, 4 * i + 2);
  return {packed.low.x() + packed.extent.x() * x / 4095, packed.low.y() + packed.extent.y() * y / 4095,
          wrap(kTwoPi * byteAt(packed, 4 * i + 3) / 256)};
}
}  // namespace

TEST(PackPoses, KeepsPositionsToAFourThousandthOfTheirBox)
{
  std::vector<Pose2> poses;
  for (int i = 0; i < 300; ++i) poses.push_back({-3 + 0.05 * i, 7 * std::sin(0.1 * i), wrap(0.37 * i)});
  const PackedPoses packed = packPoses(poses);
  ASSERT_EQ(packed.bytes.size(), 4 * poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i)
  {
    EXPECT_NEAR(unpacked(packed, i).x, poses[i].x, packed.extent.x() / 8190 + 1e-12);
    EXPECT_NEAR(unpacked(packed, i).y, poses[i].y, packed.extent.y() / 8190 + 1e-12);
    EXPECT_LE(std::abs(wrap(unpacked(packed, i).phi - poses[i].phi)), kTwoPi / 512 + 1e-12);
  }
}

TEST(PackPoses, OfOnePositionOrNone)
{
  EXPECT_TRUE(packPoses({}).bytes.empty());
  const PackedPoses packed = packPoses({{1, 2, 3}, {1, 2, -3}});
  EXPECT_EQ(unpacked(packed, 1).x, 1);
  EXPECT_EQ(unpacked(packed, 1).y, 2);
}

// RFC 4648, section 10.
TEST(Base64, OfTheTestVectors)
{
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}
}  // namespace mrpt_ext::test_packed_particles
