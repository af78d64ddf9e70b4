#include "mrpt_ext/rawlog/decompressed_file.h"

#include <cerrno>
#include <cstring>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
DecompressedFile::DecompressedFile(const std::filesystem::path& path, Sha256* digest)
    : path_(path), digest_(digest), buffer_(1 << 16)
{
  if (std::filesystem::is_directory(path)) throw dataError(path.string() + ": is a folder, expected a rawlog file");
  file_.open(path, std::ios::binary);
  if (!file_) throw dataError(path.string() + ": cannot be opened (" + std::strerror(errno) + ")");
  readBytes();
  if (bytes_.empty()) throw dataError(path.string() + ": the file is empty, expected a rawlog");
  compression_ = compressionOf(bytes_);
  decompressor_ = makeDecompressor(compression_);
}

std::size_t DecompressedFile::read(std::span<unsigned char> out)
{
  std::size_t total = 0;
  while (total < out.size())
  {
    if (bytes_.empty() && !ended_) readBytes();
    const std::size_t available = bytes_.size();
    const std::size_t got = decompressor_->decompress(bytes_, out.subspan(total));
    total += got;
    const bool stuck = got == 0 && bytes_.size() == available;
    if (stuck && (ended_ || available > 0)) break;
  }
  return total;
}

void DecompressedFile::readRest()
{
  while (!ended_) readBytes();
  bytes_ = {};
}

std::string DecompressedFile::damage() const
{
  if (!decompressor_->damage().empty()) return decompressor_->damage();
  return decompressor_->complete() ? "" : "the compressed data ends early, the file is truncated";
}

void DecompressedFile::readBytes()
{
  file_.read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(buffer_.size()));
  if (file_.bad()) throw dataError(path_.string() + ": cannot be read to its end (" + std::strerror(errno) + ")");
  bytes_ = {buffer_.data(), static_cast<std::size_t>(file_.gcount())};
  ended_ = !file_;
  if (digest_) digest_->add(bytes_);
}
}  // namespace mrpt_ext
