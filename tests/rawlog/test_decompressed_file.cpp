#include "mrpt_ext/rawlog/decompressed_file.h"

#include <zstd.h>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_decompressed_file
{
namespace
{
/// As `checksum = false`: MRPT, `true`: the tool zstd.
std::string zstdCompress(const std::string& content, bool checksum)
{
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, checksum ? 1 : 0);
  std::string bytes(ZSTD_compressBound(content.size()), '\0');
  bytes.resize(ZSTD_compress2(context, bytes.data(), bytes.size(), content.data(), content.size()));
  ZSTD_freeCCtx(context);
  return bytes;
}

std::string skippableFrame(const std::string& text)
{
  std::string frame = "\x5a\x2a\x4d\x18";
  frame += static_cast<char>(text.size());
  return frame + std::string(3, '\0') + text;
}

class ZstdRawlog : public RawlogTest
{
 protected:
  void SetUp() override
  {
    RawlogTest::SetUp();
    writeRawlog(inFolder("good.rawlog"), sampleRecording(4));
    content_ = decompress(readBytes(inFolder("good.rawlog")));
  }
  [[nodiscard]] ReadResult read(const std::string& bytes) const
  {
    writeBytes(inFolder("zstd.rawlog"), bytes);
    return readLog(inFolder("zstd.rawlog"));
  }
  std::string content_;
};
}  // namespace

TEST_F(ZstdRawlog, HoldsTheSameRecords)
{
  const std::size_t records = readLog(inFolder("good.rawlog")).records.size();
  for (const bool checksum : {false, true})
  {
    const ReadResult result = read(zstdCompress(content_, checksum));
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.records.size(), records);
  }
}

TEST_F(ZstdRawlog, FramesMayBeSeveralOrSkippable)
{
  const std::string first = zstdCompress(content_.substr(0, 1000), true);
  const std::string second = zstdCompress(content_.substr(1000), false);
  const ReadResult result = read(skippableFrame("of pzstd") + first + skippableFrame("index") + second);
  EXPECT_EQ(result.error, "");
  EXPECT_EQ(result.records.size(), readLog(inFolder("good.rawlog")).records.size());
  EXPECT_NE(read(skippableFrame("alone")).error.find("the compressed file is empty"), std::string::npos);
}

TEST_F(ZstdRawlog, EveryTruncationIsToldWithTheRecord)
{
  const std::string good = zstdCompress(content_, false);
  for (std::size_t length = 1; length < good.size(); ++length)
  {
    const ReadResult result = read(good.substr(0, length));
    EXPECT_NE(result.error.find(": record "), std::string::npos) << length;
  }
  EXPECT_NE(read(good.substr(0, good.size() / 2)).error.find("truncated"), std::string::npos);
}

TEST_F(ZstdRawlog, AFlippedByteIsToldWithTheRecord)
{
  const std::string good = zstdCompress(content_, true);
  RandomStream random(1);
  for (int i = 0; i < 300; ++i)
  {
    std::string bytes = good;
    const std::size_t at = random.below(bytes.size());
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + random.below(255)));
    const std::string error = read(bytes).error;
    EXPECT_NE(error, "") << at;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_NE(read(good + "trailing garbage").error, "");
}

// Pieces that end within the buffers of the decompressors.
TEST_F(ZstdRawlog, LongContentIsTheSameInAnyCompression)
{
  RandomStream random(2);
  std::string content(300'000, '\0');
  for (char& c : content) c = static_cast<char>(random.below(4));
  for (const std::string& bytes : {content, compress(content), zstdCompress(content, false)})
  {
    writeBytes(inFolder("long"), bytes);
    DecompressedFile file(inFolder("long"));
    std::string read(content.size() + 10, '\0');
    std::size_t got = 0;
    for (const std::size_t piece : {1U, 65536U, 99'999U, 1000U, 400'000U})
    {
      const std::size_t wanted = std::min<std::size_t>(piece, read.size() - got);
      got += file.read({reinterpret_cast<unsigned char*>(read.data()) + got, wanted});
    }
    read.resize(got);
    EXPECT_TRUE(read == content);
    EXPECT_EQ(file.damage(), "");
  }
}
}  // namespace mrpt_ext::test_decompressed_file
