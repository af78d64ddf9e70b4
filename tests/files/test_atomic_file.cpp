#include "mrpt_ext/files/atomic_file.h"

#include <gtest/gtest.h>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext
{
using testing::messageOf;
using testing::ScratchFolder;

namespace
{
std::ptrdiff_t filesIn(const std::filesystem::path& folder)
{
  return std::distance(std::filesystem::directory_iterator(folder), {});
}
}  // namespace

TEST(WriteFileAtomically, ReplacesContentAndLeavesNoTemporary)
{
  const ScratchFolder folder;
  const auto path = folder.path() / "new" / "out.txt";
  writeFileAtomically(path, "first");
  writeFileAtomically(path, "second");
  EXPECT_EQ(readTextFile(path), "second");
  EXPECT_EQ(filesIn(path.parent_path()), 1);
}

TEST(WriteFileAtomically, UnwritablePathIsAnInputError)
{
  const ScratchFolder folder;
  folder.write("file", "");
  const auto message = messageOf<InputError>([&] { writeFileAtomically(folder.path() / "file" / "out.txt", "x"); });
  EXPECT_NE(message.find("out.txt: cannot be written ("), std::string::npos) << message;
}

TEST(WriteFileAtomically, FailureKeepsTheOldContentAndCleansUp)
{
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "taken" / "inside");  // a folder cannot be replaced by a file
  EXPECT_THROW(writeFileAtomically(folder.path() / "taken", "x"), InputError);
  EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(WriteFileAtomically, FullDiskIsAnInputError)
{
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const ScratchFolder folder;
  // The next temporary name becomes a link to a device that is always full.
  const auto path = folder.path() / "out.txt";
  const std::string name = temporaryNameFor(path).string();
  const std::size_t dash = name.rfind('-');
  const std::string next = name.substr(0, dash + 1) + std::to_string(std::stoul(name.substr(dash + 1)) + 1);
  std::filesystem::create_symlink("/dev/full", next);
  const auto message = messageOf<InputError>([&] { writeFileAtomically(path, "content"); });
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_EQ(filesIn(folder.path()), 0);
}
}  // namespace mrpt_ext
