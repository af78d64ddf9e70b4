#include "mrpt_ext/files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  if (folder_ < 0 || flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw dataError(folder.string() + ": another program is writing into it, expected a folder of its own (-o)");
}

FolderLock::~FolderLock()
{
  if (folder_ >= 0) close(folder_);
}
}  // namespace mrpt_ext
