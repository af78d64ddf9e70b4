#include "mrpt_ext/rawlog/rawlog_content.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kChunk = 1 << 16;
}  // namespace

RawlogContent::RawlogContent(const std::filesystem::path& path, std::uint64_t size)
    : path_(path), file_(path), size_(size)
{
}

size_t RawlogContent::Read(void* buffer, size_t count)
{
  auto* out = static_cast<unsigned char*>(buffer);
  const std::size_t from_buffer = std::min(count, buffered());
  if (from_buffer > 0) std::memcpy(out, buffer_.data() + begin_, from_buffer);
  begin_ += from_buffer;
  std::size_t got = from_buffer;
  // Small reads go through the buffer, large ones past it.
  if (got < count && count - got >= kChunk) got += file_.read({out + got, count - got});
  position_ += got;
  if (got == count || peek(1).empty()) return got;
  return got + Read(out + got, count - got);
}

size_t RawlogContent::Write(const void*, size_t) { throw std::logic_error("the content of a rawlog is only read"); }

std::uint64_t RawlogContent::Seek(std::int64_t, CStream::TSeekOrigin) { throw std::logic_error("not seekable"); }

std::span<const unsigned char> RawlogContent::peek(std::size_t count)
{
  if (buffered() < count)
  {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
    const std::size_t kept = buffer_.size();
    buffer_.resize(std::max(count, kChunk));
    buffer_.resize(kept + file_.read({buffer_.data() + kept, buffer_.size() - kept}));
  }
  return {buffer_.data() + begin_, std::min(count, buffered())};
}

void RawlogContent::skip(std::size_t count)
{
  count = std::min(count, peek(count).size());
  begin_ += count;
  position_ += count;
}
}  // namespace mrpt_ext
