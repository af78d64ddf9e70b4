#pragma once

#include <filesystem>

namespace mrpt_ext
{
/// Keeps a second program from writing into the same folder. The lock is on the folder itself (flock), so that nothing
/// is left behind when the program is killed. Where the file system knows no locks, there is none.
class FolderLock
{
 public:
  /// The folder must exist. Throws InputError (data) when another program has it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;
};
}  // namespace mrpt_ext
