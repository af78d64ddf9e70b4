#include "mrpt_ext/front_ends/image_integrity.h"

#include <zlib.h>

#include <cstdint>

#include "mrpt_ext/front_ends/jpeg_integrity.h"
#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
using namespace std::string_view_literals;

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n"sv;
constexpr const char* kDamaged = "image is missing, empty or damaged";
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum of a PNG chunk [bytes]

std::uint32_t bigEndian(std::string_view bytes)
{
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::string whyTooLarge(double width, double height)
{
  if (width * height <= kMostPixels) return {};
  return formatted("image of %.0f x %.0f pixels, expected at most %.0f million", width, height, kMostPixels / 1e6);
}

/// Every chunk must be whole, down to the last one.
std::string whyNoPng(std::string_view bytes)
{
  bytes.remove_prefix(kPngStart.size());
  for (bool first = true; bytes.size() >= kChunkFrame; first = false)
  {
    const std::size_t length = bigEndian(bytes);
    if (length > bytes.size() - kChunkFrame) return kDamaged;
    const std::string_view type = bytes.substr(4, 4), checked = bytes.substr(4, 4 + length);
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
    if (sum != bigEndian(bytes.substr(8 + length)) || (first && (type != "IHDR" || length < 8))) return kDamaged;
    if (first)
      if (std::string why = whyTooLarge(bigEndian(bytes.substr(8)), bigEndian(bytes.substr(12))); !why.empty())
        return why;
    if (type == "IEND") return {};
    bytes.remove_prefix(kChunkFrame + length);
  }
  return kDamaged;
}

std::string whyNoJpeg(std::string_view bytes)
{
  const auto size = jpegSize(bytes);
  if (!size) return kDamaged;
  if (std::string why = whyTooLarge(size->first, size->second); !why.empty()) return why;
  return isWholeJpeg(bytes) ? "" : kDamaged;
}
}  // namespace

std::string whyNoImage(std::string_view bytes)
{
  if (bytes.starts_with("\xFF\xD8"sv)) return whyNoJpeg(bytes);
  if (bytes.starts_with(kPngStart)) return whyNoPng(bytes);
  return kDamaged;
}
}  // namespace mrpt_ext
