#include "mrpt_ext/importers/rosbag2/mcap_reader.h"

#include <gtest/gtest.h>

#include "bag_samples.h"
#include "sample_data.h"

namespace mrpt_ext::test_mcap_reader
{
namespace
{
std::vector<std::string> topicsIn(const std::filesystem::path& path, std::vector<std::string>* notes = nullptr)
{
  return testing::topicsOf(
      [&](const BagMessageSink& sink)
      {
        const auto told = readMcap(path, sink);
        if (notes) *notes = told;
      });
}
}  // namespace

TEST(McapReader, ChunksMayBeZstdOrLz4)
{
  const auto zstd = topicsIn(testing::bag("drive_zstd.mcap")), lz4 = topicsIn(testing::bag("drive_lz4.mcap"));
  EXPECT_EQ(zstd.size(), 197U);
  EXPECT_EQ(zstd.front(), "/tf_static");
  EXPECT_EQ(lz4, zstd);
}

TEST(McapReader, NeedsNoChunksAndNoIndex)
{
  std::vector<std::string> notes;
  EXPECT_EQ(topicsIn(testing::bag("plain.mcap"), &notes).size(), 108U);
  EXPECT_TRUE(notes.empty());
}

TEST(McapReader, ReadsARecordingThatWasCutOff)
{
  const testing::ScratchFolder folder;
  for (const char* name : {"drive_zstd.mcap", "plain.mcap"})
  {
    const std::string bytes = readTextFile(testing::bag(name));
    std::vector<std::string> notes;
    const auto path = folder.write("cut.mcap", bytes.substr(0, bytes.size() / 2));
    const std::size_t messages = topicsIn(path, &notes).size();
    EXPECT_GT(messages, 20U) << name;
    EXPECT_LT(messages, 198U) << name;
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("was cut off"), std::string::npos) << notes[0];
    // Zeros at the end are what a file system leaves of a machine that stopped.
    const auto padded = folder.write("padded.mcap", bytes.substr(0, bytes.size() / 2) + std::string(100, '\0'));
    EXPECT_LE(topicsIn(padded, &notes).size(), messages + 1);
    EXPECT_EQ(notes.size(), 1U);
  }
}

TEST(McapReader, DamageIsALineWithTheByte)
{
  const testing::ScratchFolder folder;
  std::string bytes = readTextFile(testing::bag("drive_zstd.mcap"));
  bytes[bytes.find("zstd") + 200] ^= 0x10;  // in the first chunk
  EXPECT_INPUT_ERROR(topicsIn(folder.write("damaged.mcap", bytes)), "damaged.mcap: record at byte ");
  EXPECT_INPUT_ERROR(topicsIn(folder.write("other.mcap", "something else")), "no MCAP file");
  EXPECT_INPUT_ERROR(topicsIn(folder.path() / "none.mcap"), "cannot be opened");
}

TEST(McapReader, AnUnknownChannelIsDamage)
{
  const testing::ScratchFolder folder;
  using namespace std::string_literals;
  const std::string magic = "\x89MCAP0\r\n"s;
  const std::string record = "\x05\x16\0\0\0\0\0\0\0"s + std::string(22, '\0');
  EXPECT_INPUT_ERROR(topicsIn(folder.write("a.mcap", magic + record + magic)), "byte 8: a message of channel 0");
}
}  // namespace mrpt_ext::test_mcap_reader
