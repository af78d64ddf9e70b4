#include "mrpt_ext/files/text_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_text_file
{
using testing::messageOf;
using testing::ScratchFolder;

namespace
{
void writeGzip(const std::filesystem::path& path, const std::string& content)
{
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
  gzclose(file);
}

std::string manyLines()
{
  std::string content;
  for (int i = 0; i < 50000; ++i) content += std::to_string(i * 7919 % 100003) + '\n';
  return content;
}
}  // namespace

TEST(ReadTextFile, PlainAndGzipGiveTheSameText)
{
  const ScratchFolder folder;
  const std::string content = manyLines();
  writeGzip(folder.path() / "data.gz", content);
  EXPECT_EQ(readTextFile(folder.path() / "data.gz"), content);
  EXPECT_EQ(readTextFile(folder.write("data", content)), content);
  EXPECT_EQ(readTextFile(folder.write("empty", "")), "");
}

TEST(ReadTextFile, CutOffOrDamagedGzipIsAnError)
{
  const ScratchFolder folder;
  writeGzip(folder.path() / "data.gz", manyLines());
  const std::string packed = [&]
  {
    std::ifstream file(folder.path() / "data.gz", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  for (const std::size_t length : {packed.size() / 2, packed.size() - 4, packed.size() - 1})
    EXPECT_THROW((void)readTextFile(folder.write("cut.gz", packed.substr(0, length))), InputError) << length;
  std::string flipped = packed;
  flipped[packed.size() / 2] = static_cast<char>(flipped[packed.size() / 2] ^ 0x10);
  EXPECT_THROW((void)readTextFile(folder.write("flipped.gz", flipped)), InputError);
}

TEST(ReadTextFile, MissingFileAndFolderAreNamed)
{
  const ScratchFolder folder;
  EXPECT_NE(messageOf<InputError>([&] { (void)readTextFile(folder.path() / "none"); }).find("none: no such file"),
            std::string::npos);
  EXPECT_NE(messageOf<InputError>([&] { (void)readTextFile(folder.path()); }).find("is a folder"), std::string::npos);
}

TEST(FindPlainOrGzipped, PrefersThePlainFile)
{
  const ScratchFolder folder;
  EXPECT_FALSE(findPlainOrGzipped(folder.path() / "a"));
  folder.write("a.gz", "");
  EXPECT_EQ(findPlainOrGzipped(folder.path() / "a"), folder.path() / "a.gz");
  folder.write("a", "");
  EXPECT_EQ(findPlainOrGzipped(folder.path() / "a"), folder.path() / "a");
}
}  // namespace mrpt_ext::test_text_file
