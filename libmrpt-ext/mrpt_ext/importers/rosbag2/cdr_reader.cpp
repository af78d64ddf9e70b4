#include "mrpt_ext/importers/rosbag2/cdr_reader.h"

#include <string>

namespace mrpt_ext
{
CdrReader::CdrReader(std::string_view message)
{
  constexpr std::size_t kHeader = 4;  // [bytes]
  if (message.size() < kHeader) throw DamagedBytes("shorter than the header of CDR");
  const int form = numberAt<std::uint16_t>(message.data(), std::endian::big);
  if (form > 1)
    throw DamagedBytes("CDR of form " + std::to_string(form) + ", expected 0 (big endian) or 1 (little endian)");
  order_ = form == 0 ? std::endian::big : std::endian::little;
  body_ = message.substr(kHeader);
}

std::string_view CdrReader::take(std::size_t count)
{
  if (count > left()) throw DamagedBytes("a value goes beyond the end of the message");
  const std::string_view bytes = body_.substr(at_, count);
  at_ += count;
  return bytes;
}

std::string_view CdrReader::text()
{
  std::string_view bytes = take(number<std::uint32_t>());
  if (!bytes.empty() && bytes.back() == '\0') bytes.remove_suffix(1);
  return bytes;
}

std::uint32_t CdrReader::sequenceLength(std::size_t least_size)
{
  const auto length = number<std::uint32_t>();
  if (length > left() / least_size)
    throw DamagedBytes("a sequence of " + std::to_string(length) + " elements goes beyond the end of the message");
  return length;
}
}  // namespace mrpt_ext
