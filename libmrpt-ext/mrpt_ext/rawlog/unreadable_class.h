#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/rawlog/object_header.h"

namespace mrpt_ext
{
/// A class, or a version of it, that the installed MRPT cannot read.
struct UnreadableClass
{
  std::string class_name;      ///< with its namespace
  std::optional<int> version;  ///< absent: the class itself is unknown

  /// E.g. "version 8, written by MRPT 2.15.6 or newer".
  [[nodiscard]] std::string reason() const;
  /// The sentence for a user whose log needs the class.
  [[nodiscard]] std::string explanation() const;
};

/// What MRPT's exception says about an object with this header; nothing when the object is damaged.
[[nodiscard]] std::optional<UnreadableClass> unreadableClass(const ObjectHeader& header, const std::string& exception);
}  // namespace mrpt_ext
