#pragma once

#include <mrpt/io/CStream.h>

#include <filesystem>
#include <span>
#include <vector>

#include "mrpt_ext/rawlog/decompressed_file.h"

namespace mrpt_ext
{
/// The decompressed bytes of a log as a stream of MRPT, counted, with a look ahead: the log ends where no byte is left,
/// and nowhere else.
class RawlogContent : public mrpt::io::CStream
{
 public:
  /// `size`: number of bytes after decompression.
  RawlogContent(const std::filesystem::path& path, std::uint64_t size);

  size_t Read(void* buffer, size_t count) override;
  size_t Write(const void*, size_t) override;
  std::uint64_t Seek(std::int64_t, CStream::TSeekOrigin) override;
  std::uint64_t getTotalBytesCount() const override { return size_; }
  std::uint64_t getPosition() const override { return position_; }
  std::string getStreamDescription() const override { return path_.string(); }

  /// The next `count` bytes, fewer at the end; they stay to be read. Valid until the next call.
  [[nodiscard]] std::span<const unsigned char> peek(std::size_t count);
  void skip(std::size_t count);
  [[nodiscard]] bool atEnd() const { return position_ >= size_; }
  [[nodiscard]] std::uint64_t bytesLeft() const { return atEnd() ? 0 : size_ - position_; }

 private:
  [[nodiscard]] std::size_t buffered() const { return buffer_.size() - begin_; }

  std::filesystem::path path_;
  DecompressedFile file_;
  std::uint64_t size_, position_ = 0;
  std::vector<unsigned char> buffer_;  ///< from begin_ on not yet read
  std::size_t begin_ = 0;
};
}  // namespace mrpt_ext
