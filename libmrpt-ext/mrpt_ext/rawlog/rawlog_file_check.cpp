#include "mrpt_ext/rawlog/rawlog_file_check.h"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/sha256.h"

namespace mrpt_ext
{
namespace
{
using Bytes = std::span<unsigned char>;

/// Decompresses only to count and to compare lengths and checksums.
class GzipChecker
{
 public:
  GzipChecker() { inflateInit2(&stream_, 15 + 16); }  // 15: largest window, 16: gzip header and trailer
  ~GzipChecker() { inflateEnd(&stream_); }
  GzipChecker(const GzipChecker&) = delete;
  GzipChecker& operator=(const GzipChecker&) = delete;

  void add(Bytes bytes)
  {
    stream_.next_in = bytes.data();
    stream_.avail_in = static_cast<unsigned int>(bytes.size());
    while (stream_.avail_in > 0 && damage_.empty()) step();
  }
  [[nodiscard]] std::uint64_t content() const { return content_; }
  [[nodiscard]] std::string damage() const
  {
    if (!damage_.empty()) return damage_;
    return member_ended_ ? "" : "the compressed data ends early, the file is truncated";
  }

 private:
  void step()
  {
    if (member_ended_) inflateReset(&stream_);  // gzip files may be concatenated
    member_ended_ = false;
    stream_.next_out = buffer_.data();
    stream_.avail_out = static_cast<unsigned int>(buffer_.size());
    const int code = inflate(&stream_, Z_NO_FLUSH);
    content_ += buffer_.size() - stream_.avail_out;
    member_ended_ = code == Z_STREAM_END;
    if (code != Z_OK && code != Z_STREAM_END)
      damage_ = std::string("the compressed data is damaged (") + (stream_.msg ? stream_.msg : zError(code)) + ")";
  }

  z_stream stream_{};
  std::vector<unsigned char> buffer_ = std::vector<unsigned char>(1 << 16);
  std::uint64_t content_ = 0;
  bool member_ended_ = false;
  std::string damage_;
};

bool isGzip(Bytes start) { return start.size() >= 2 && start[0] == 0x1f && start[1] == 0x8b; }
}  // namespace

RawlogFileCheck checkRawlogFile(const std::filesystem::path& path)
{
  if (std::filesystem::is_directory(path)) throw dataError(path.string() + ": is a folder, expected a rawlog file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw dataError(path.string() + ": cannot be opened (" + std::strerror(errno) + ")");

  RawlogFileCheck check;
  Sha256 digest;
  GzipChecker gzip;
  std::uint64_t size = 0;
  std::vector<unsigned char> buffer(1 << 16);
  while (file)
  {
    file.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(buffer.size()));
    const Bytes bytes(buffer.data(), static_cast<std::size_t>(file.gcount()));
    if (size == 0) check.compressed = isGzip(bytes);
    size += bytes.size();
    digest.add(bytes);
    if (check.compressed) gzip.add(bytes);
  }
  if (file.bad()) throw dataError(path.string() + ": cannot be read to its end (" + std::strerror(errno) + ")");
  if (size == 0) throw dataError(path.string() + ": the file is empty, expected a rawlog");
  check.sha256 = digest.hex();
  check.content = check.compressed ? gzip.content() : size;
  if (check.compressed) check.damage = gzip.damage();
  if (check.content == 0 && check.damage.empty())
    throw dataError(path.string() + ": the compressed file is empty, expected a rawlog");
  return check;
}
}  // namespace mrpt_ext
