#include "mrpt_ext/rawlog/object_header.h"

#include <algorithm>
#include <cctype>

#include "mrpt_ext/rawlog/rawlog_content.h"

namespace mrpt_ext
{
namespace
{
using Bytes = std::span<const unsigned char>;

bool isNameCharacter(unsigned char c) { return std::isalnum(c) || c == '_' || c == ':' || c == '<' || c == '>'; }

/// The bytes begin with an entry of a log, or are none.
bool isEntryOrEnd(Bytes bytes)
{
  if (bytes.empty()) return true;
  const auto header = headerAt(bytes);
  if (!header) return false;
  const std::string name = withoutNamespace(header->class_name);
  return name.starts_with("CObservation") || name.starts_with("CAction") || name == "CSensoryFrame";
}
}  // namespace

std::optional<ObjectHeader> headerAt(Bytes bytes)
{
  if (bytes.empty() || (bytes[0] & 0x80) == 0) return std::nullopt;
  const std::size_t length = bytes[0] & 0x7f;
  if (length == 0 || bytes.size() < length + 2) return std::nullopt;
  const Bytes name = bytes.subspan(1, length);
  if (!std::all_of(name.begin(), name.end(), isNameCharacter)) return std::nullopt;
  return ObjectHeader{{name.begin(), name.end()}, bytes[length + 1]};
}

std::string withoutNamespace(const std::string& class_name)
{
  const auto colons = class_name.rfind("::");
  return colons == std::string::npos ? class_name : class_name.substr(colons + 2);
}

bool skipObject(RawlogContent& content, bool ends_frame)
{
  const std::size_t ends = ends_frame ? 2 : 1;
  for (; !content.atEnd(); content.skip(1))
  {
    const Bytes bytes = content.peek(ends + kLongestHeader);
    const bool ended = bytes.size() >= ends && bytes[0] == kObjectEnd && bytes[ends - 1] == kObjectEnd;
    if (!ended || !isEntryOrEnd(bytes.subspan(ends))) continue;
    content.skip(1);
    return true;
  }
  return false;
}
}  // namespace mrpt_ext
