#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// A place on disk for what does not fit into memory: blocks of bytes that are written once and read back in any order.
/// The file lies in the folder for temporary files (TMPDIR) and has no name any more once it is open, so that nothing
/// is left behind, however the program ends. Several threads may write and read at once.
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
