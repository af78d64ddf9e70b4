#include "mrpt_ext/front_ends/image_integrity.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_image_integrity
{
namespace
{
const std::string kDamaged = "image is missing, empty or damaged";

std::string encoded(const std::string& kind)
{
  cv::Mat pixels(120, 160, CV_8UC3);
  RandomStream random(1);
  for (int v = 0; v < pixels.rows; ++v)
    for (int u = 0; u < pixels.cols; ++u)
      pixels.at<cv::Vec3b>(v, u) = {static_cast<unsigned char>(u + random.below(20)), static_cast<unsigned char>(v), 0};
  std::vector<unsigned char> bytes;
  cv::imencode(kind, pixels, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string faultyImage(const std::string& name)
{
  return readTextFile(std::string(MRPT_EXT_TEST_DATA) + "/faults/" + name);
}
}  // namespace

TEST(ImageIntegrity, WholeImagesAreFine)
{
  EXPECT_EQ(whyNoImage(encoded(".jpg")), "");
  EXPECT_EQ(whyNoImage(encoded(".png")), "");
}

TEST(ImageIntegrity, EveryTruncationIsDamage)
{
  for (const std::string kind : {".jpg", ".png"})
  {
    const std::string good = encoded(kind);
    for (std::size_t length = 0; length < good.size(); length += 1 + length / 50)
      EXPECT_EQ(whyNoImage(std::string_view(good).substr(0, length)), kDamaged) << kind << ' ' << length;
  }
}

TEST(ImageIntegrity, ChangedBytesOfAPngAreDamage)
{
  const std::string good = encoded(".png");
  for (std::size_t at = 8; at < good.size(); at += 1 + good.size() / 200)
  {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    EXPECT_NE(whyNoImage(bytes), "") << at;
  }
}

// Behind the Huffman codes a JPEG has no checksum: bytes that still make codes are other pixels, all else is damage.
TEST(ImageIntegrity, WhatAJpegDecoderWouldRepairIsDamage)
{
  EXPECT_EQ(whyNoImage(faultyImage("damaged_but_used.jpg")), kDamaged);
}

TEST(ImageIntegrity, AHugeHeaderIsRefusedWithoutMemory)
{
  EXPECT_EQ(whyNoImage(faultyImage("png_65535x65535.png")),
            "image of 65535 x 65535 pixels, expected at most 50 million");
}

TEST(ImageIntegrity, OtherFormatsAreNotRead) { EXPECT_EQ(whyNoImage("BM some bitmap"), kDamaged); }
}  // namespace mrpt_ext::test_image_integrity
