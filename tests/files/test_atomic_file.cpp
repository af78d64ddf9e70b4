#include "mrpt_ext/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "error_message.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_atomic_file
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
  const ScratchFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // as the apps do: an error instead of a signal
  setrlimit(RLIMIT_FSIZE, &full);
  const auto message =
      messageOf<InputError>([&] { writeFileAtomically(folder.path() / "out.txt", std::string(2000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("out.txt: cannot be written (File too large)"), std::string::npos) << message;
  EXPECT_EQ(filesIn(folder.path()), 0);
}
}  // namespace mrpt_ext::test_atomic_file
