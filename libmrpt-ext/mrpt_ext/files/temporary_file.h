#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// Blocks of bytes on disk, written once and read back in any order, for data that does not fit into memory.
/// The file is in the folder for temporary files (TMPDIR) and is unlinked once it is open, so that nothing is left
/// behind however the program ends. Several threads may write and read at once.
/// Throws InputError (data) when the disk is full or cannot be read.
class TemporaryFile
{
 public:
  struct Block
  {
    std::uint64_t offset = 0, size = 0;  ///< [bytes]
  };

  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  Block append(std::string_view bytes);
  [[nodiscard]] std::string read(const Block& block) const;

 private:
  std::string folder_;
  int file_ = -1;
  std::atomic<std::uint64_t> end_ = 0;
};
}  // namespace mrpt_ext
