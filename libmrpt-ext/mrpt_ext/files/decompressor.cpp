#include "mrpt_ext/files/decompressor.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>

namespace mrpt_ext
{
namespace
{
using Input = std::span<const unsigned char>;
using Output = std::span<unsigned char>;

std::string damaged(const char* cause) { return std::string("the compressed data is damaged (") + cause + ")"; }

class NoDecompressor : public Decompressor
{
 public:
  std::size_t decompress(Input& in, Output out) override
  {
    const std::size_t count = std::min(in.size(), out.size());
    std::copy_n(in.begin(), count, out.begin());
    in = in.subspan(count);
    return count;
  }
  const std::string& damage() const override { return damage_; }
  bool complete() const override { return true; }

 private:
  std::string damage_;
};

class GzipDecompressor : public Decompressor
{
 public:
  GzipDecompressor() { inflateInit2(&stream_, 15 + 16); }  // 15: largest window, 16: gzip header and trailer
  ~GzipDecompressor() override { inflateEnd(&stream_); }
  GzipDecompressor(const GzipDecompressor&) = delete;
  GzipDecompressor& operator=(const GzipDecompressor&) = delete;

  std::size_t decompress(Input& in, Output out) override
  {
    if (!damage_.empty() || (in.empty() && complete_)) return 0;
    if (complete_) inflateReset(&stream_);
    stream_.next_in = const_cast<unsigned char*>(in.data());
    stream_.avail_in = static_cast<unsigned int>(in.size());
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<unsigned int>(out.size());
    const int code = inflate(&stream_, Z_NO_FLUSH);
    in = in.last(stream_.avail_in);
    complete_ = code == Z_STREAM_END;
    const bool needs_input = code == Z_BUF_ERROR;
    if (code != Z_OK && !complete_ && !needs_input) damage_ = damaged(stream_.msg ? stream_.msg : zError(code));
    return out.size() - stream_.avail_out;
  }
  const std::string& damage() const override { return damage_; }
  bool complete() const override { return complete_; }

 private:
  z_stream stream_{};
  bool complete_ = false;
  std::string damage_;
};

class ZstdDecompressor : public Decompressor
{
 public:
  std::size_t decompress(Input& in, Output out) override
  {
    if (!damage_.empty() || (in.empty() && complete_)) return 0;
    ZSTD_inBuffer input{in.data(), in.size(), 0};
    ZSTD_outBuffer output{out.data(), out.size(), 0};
    const std::size_t missing = ZSTD_decompressStream(stream_.get(), &output, &input);
    in = in.subspan(input.pos);
    complete_ = missing == 0;
    if (ZSTD_isError(missing)) damage_ = damaged(ZSTD_getErrorName(missing));
    return output.pos;
  }
  const std::string& damage() const override { return damage_; }
  bool complete() const override { return complete_; }

 private:
  std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream_{ZSTD_createDStream(), &ZSTD_freeDStream};
  bool complete_ = false;
  std::string damage_;
};
}  // namespace

Compression compressionOf(Input start)
{
  if (start.size() >= 2 && start[0] == 0x1f && start[1] == 0x8b) return Compression::gzip;
  if (start.size() < 4) return Compression::none;
  const bool frame = start[0] == 0x28 && start[1] == 0xb5 && start[2] == 0x2f && start[3] == 0xfd;
  const bool skippable = (start[0] & 0xf0) == 0x50 && start[1] == 0x2a && start[2] == 0x4d && start[3] == 0x18;
  return frame || skippable ? Compression::zstd : Compression::none;
}

std::unique_ptr<Decompressor> makeDecompressor(Compression compression)
{
  if (compression == Compression::gzip) return std::make_unique<GzipDecompressor>();
  if (compression == Compression::zstd) return std::make_unique<ZstdDecompressor>();
  return std::make_unique<NoDecompressor>();
}
}  // namespace mrpt_ext
