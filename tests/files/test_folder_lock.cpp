#include "mrpt_ext/files/folder_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <memory>

#include "error_message.h"
#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_folder_lock
{
TEST(FolderLock, ASecondWriterIsRefusedUntilTheFirstEnds)
{
  const testing::ScratchFolder folder;
  auto first = std::make_unique<FolderLock>(folder.path());
  EXPECT_EQ(testing::messageOf<InputError>([&] { const FolderLock second(folder.path()); }),
            folder.path().string() + ": another program is writing into it, expected a folder of its own (-o)");
  first.reset();
  const FolderLock third(folder.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing is left behind";
}

TEST(FolderLock, EndsWithItsProcess)
{
  const testing::ScratchFolder folder;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
  {
    const FolderLock lock(folder.path());
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  const FolderLock lock(folder.path());
}

TEST(FolderLock, AFolderThatDoesNotExistIsNoReasonToFail)
{
  const testing::ScratchFolder folder;
  const FolderLock lock(folder.path() / "none");
}
}  // namespace mrpt_ext::test_folder_lock
