#include "mrpt_ext/app/printable_stream.h"

#include <cerrno>

namespace mrpt_ext
{
namespace
{
using Byte = unsigned char;

bool isControl(char32_t code) { return (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0); }

/// Bytes of the UTF-8 character that `text` begins with and its code; no bytes when it is not valid.
std::pair<std::size_t, char32_t> decodedStart(std::string_view text)
{
  const Byte lead = static_cast<Byte>(text[0]);
  if (lead < 0x80) return {1, lead};
  const std::size_t length = lead >= 0xf0 && lead < 0xf5   ? 4
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                                                           : 0;
  if (length == 0 || text.size() < length) return {0, 0};
  char32_t code = lead & (0xff >> (length + 1));
  for (std::size_t i = 1; i < length; ++i)
  {
    const Byte next = static_cast<Byte>(text[i]);
    if ((next & 0xc0) != 0x80) return {0, 0};
    code = (code << 6) | (next & 0x3f);
  }
  return {length, code};
}

void appendEscaped(std::string& result, std::string_view bytes)
{
  constexpr const char* kHex = "0123456789abcdef";
  for (const char c : bytes)
  {
    const Byte byte = static_cast<Byte>(c);
    (result += "\\x") += kHex[byte >> 4];
    result += kHex[byte & 0xf];
  }
}
}  // namespace

std::string printable(std::string_view text)
{
  std::string result;
  while (!text.empty())
  {
    const auto [length, code] = decodedStart(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (length == 0 || isControl(code))
      appendEscaped(result, character);
    else
      result += character;
    text.remove_prefix(character.size());
  }
  return result;
}

int PrintableStream::LineBuffer::overflow(int character)
{
  if (character == traits_type::eof()) return 0;
  line_ += static_cast<char>(character);
  if (character != '\n') return character;
  return passOn(false) ? character : traits_type::eof();
}

int PrintableStream::LineBuffer::sync() { return passOn(true) ? 0 : -1; }

bool PrintableStream::LineBuffer::passOn(bool flushed)
{
  const bool failed_before = !target_.good();
  errno = 0;
  target_ << printable(line_);
  if (flushed) target_.flush();
  line_.clear();
  if (!failed_before && !target_.good()) error_ = errno;
  return target_.good();
}
}  // namespace mrpt_ext
