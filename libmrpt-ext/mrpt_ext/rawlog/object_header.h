#pragma once

#include <optional>
#include <span>
#include <string>

namespace mrpt_ext
{
class RawlogContent;

/// What MRPT writes before each object: 0x80 | length of the name, the name of the class, its version. An object has no
/// length; it ends with the byte 0x88.
struct ObjectHeader
{
  std::string class_name;  ///< with its namespace
  int version = 0;
  [[nodiscard]] std::size_t size() const { return class_name.size() + 2; }  ///< [bytes]
};

inline constexpr unsigned char kObjectEnd = 0x88;
inline constexpr std::size_t kLongestHeader = 130;  ///< [bytes]

/// The header at the front of the bytes; nothing where there is none, or one of MRPT before 0.5.5.
[[nodiscard]] std::optional<ObjectHeader> headerAt(std::span<const unsigned char> bytes);

/// Name without its namespace.
[[nodiscard]] std::string withoutNamespace(const std::string& class_name);

/// Leaves out the rest of an object that cannot be read, up to and with its end, which shows by the header of another
/// record of a log behind it. `ends_frame`: it is the last one in a sensory frame, whose own end follows.
/// False when the log ends first.
[[nodiscard]] bool skipObject(RawlogContent& content, bool ends_frame);
}  // namespace mrpt_ext
