#pragma once

#include <filesystem>

namespace mrpt_ext
{
/// A new file under a temporary name in the folder of its target, to be renamed to the target once it is complete: who
/// reads the target sees the old content or all of the new. Missing parent folders are created.
///
/// The name is random and the file is created anew (O_EXCL, O_NOFOLLOW), so that nobody else's file or link is written
/// through. It is locked while it is written; files of such names that nobody locks are left over from a program that
/// was killed, and are removed when another file is written into the folder.
///
/// Throws InputError (data) that names the target when the folder is not writable or the disk is full.
class StagedFile
{
 public:
  explicit StagedFile(std::filesystem::path target);
  ~StagedFile();  ///< removes what was not committed
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return temporary_; }
  [[nodiscard]] int descriptor() const { return file_; }

  /// The content is complete and out of all buffers of the program: it reaches the disk before it takes its name, and
  /// the name before this returns.
  void commit();

  /// `errno`'s value as an error about the target.
  [[noreturn]] void fail(int error) const;

 private:
  void create();
  void discard();

  std::filesystem::path target_, temporary_;
  int file_ = -1;
  std::size_t registered_ = 0;
};

/// Removes all staged files of this process, which cannot create others afterwards: for a signal handler that ends it.
void removeStagedFiles() noexcept;
}  // namespace mrpt_ext
