#include "mrpt_ext/files/staged_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "error_message.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_staged_file
{
namespace fs = std::filesystem;
using testing::messageOf;
using testing::ScratchFolder;

namespace
{
const std::string kStray = "out.txt.tmp-0123456789abcdef";

std::vector<std::string> namesIn(const fs::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}
}  // namespace

TEST(StagedFile, TakesItsNameWhenItIsCommitted)
{
  const ScratchFolder folder;
  StagedFile file(folder.path() / "out.txt");
  ASSERT_EQ(write(file.descriptor(), "new", 3), 3);
  EXPECT_FALSE(fs::exists(folder.path() / "out.txt"));
  EXPECT_EQ(file.path().parent_path(), folder.path()) << "only within a folder is a rename atomic";
  file.commit();
  EXPECT_EQ(readTextFile(folder.path() / "out.txt"), "new");
  EXPECT_EQ(namesIn(folder.path()).size(), 1U);
}

TEST(StagedFile, DiscardsWhatWasNotCommitted)
{
  const ScratchFolder folder;
  {
    const StagedFile file(folder.path() / "out.txt");
  }
  EXPECT_TRUE(namesIn(folder.path()).empty());
}

TEST(StagedFile, NamesCannotBeForeseen)
{
  const ScratchFolder folder;
  const StagedFile first(folder.path() / "out.txt"), second(folder.path() / "out.txt");
  const std::string a = first.path().string(), b = second.path().string();
  ASSERT_EQ(a.size(), b.size());
  int equal = 0;
  for (std::size_t i = a.size() - 16; i < a.size(); ++i) equal += a[i] == b[i] ? 1 : 0;
  EXPECT_LT(equal, 10) << a << ' ' << b;
}

TEST(StagedFile, ReplacesALinkInsteadOfWritingThroughIt)
{
  const ScratchFolder folder;
  folder.write("elsewhere", "mine");
  fs::create_symlink(folder.path() / "elsewhere", folder.path() / "out.txt");
  StagedFile file(folder.path() / "out.txt");
  file.commit();
  EXPECT_EQ(readTextFile(folder.path() / "elsewhere"), "mine");
  EXPECT_FALSE(fs::is_symlink(folder.path() / "out.txt"));
}

TEST(StagedFile, RemovesWhatKilledProgramsLeft)
{
  const ScratchFolder folder;
  folder.write(kStray, "half of a file");
  folder.write("out.txt.tmp-1", "of somebody else");
  fs::create_symlink(folder.path() / "out.txt.tmp-1", folder.path() / "link.tmp-0123456789abcdef");
  StagedFile(folder.path() / "out.txt").commit();
  EXPECT_FALSE(fs::exists(folder.path() / kStray));
  EXPECT_TRUE(fs::exists(folder.path() / "out.txt.tmp-1"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link.tmp-0123456789abcdef"));
}

TEST(StagedFile, KeepsWhatALivingProgramWrites)
{
  const ScratchFolder folder;
  const int writer = open(folder.write(kStray, "half").c_str(), O_RDWR);
  ASSERT_EQ(flock(writer, LOCK_EX), 0);
  StagedFile(folder.path() / "out.txt").commit();
  EXPECT_TRUE(fs::exists(folder.path() / kStray));
  close(writer);
}

TEST(StagedFile, AreRemovedTogetherWhenAProgramIsInterrupted)
{
  const ScratchFolder folder;
  const pid_t child = fork();
  if (child == 0)
  {
    const StagedFile first(folder.path() / "a"), second(folder.path() / "b");
    removeStagedFiles();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(namesIn(folder.path()).empty());
}

// A signal may come at any moment of two threads that write files, most likely while one waits for the file system.
TEST(StagedFile, AreRemovedWheneverAProgramIsInterrupted)
{
#ifdef __has_feature
#if __has_feature(thread_sanitizer)
  GTEST_SKIP() << "the thread sanitizer holds signals back, and gives them to threads that block them by then";
#endif
#endif
  const ScratchFolder folder;
  for (int milliseconds = 0; milliseconds < 100; ++milliseconds)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      signal(SIGTERM, [](int) { removeStagedFiles(), _exit(0); });
      const auto writes = [&](const char* name)
      {
        while (true) StagedFile(folder.path() / name).commit();
      };
      std::thread other(writes, "a");
      writes("b");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5 + milliseconds % 20));
    kill(child, SIGTERM);
    int status = -1;
    waitpid(child, &status, 0);
    const auto names = namesIn(folder.path());
    ASSERT_LE(names.size(), 2U) << "of run " << milliseconds << ": " << ::testing::PrintToString(names);
  }
}

TEST(StagedFile, UnwritableFolderIsAnInputErrorAboutTheTarget)
{
  const ScratchFolder folder;
  folder.write("file", "");
  const auto message = messageOf<InputError>([&] { const StagedFile file(folder.path() / "file" / "out.txt"); });
  EXPECT_NE(message.find("out.txt: cannot be written (Not a directory)"), std::string::npos) << message;
}
}  // namespace mrpt_ext::test_staged_file
