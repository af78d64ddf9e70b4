#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mrpt_ext/importers/rosbag2/message_definition.h"

namespace mrpt_ext
{
/// A decoded message, or a part of it. Fields are found by their names, nested ones by a path such as
/// "header.stamp.sec". Throws DamagedBytes where there is no such field, or one of another kind.
class MessageValue
{
 public:
  /// A number; integers beyond 2^53 are rounded.
  [[nodiscard]] double number(std::string_view path) const { return kindAt<double>(path, "a number"); }
  [[nodiscard]] const std::string& text(std::string_view path) const { return kindAt<std::string>(path, "a text"); }
  [[nodiscard]] const std::vector<double>& numbers(std::string_view path) const
  {
    return kindAt<std::vector<double>>(path, "a list of numbers");
  }
  /// Elements of a list of texts or structures.
  [[nodiscard]] const std::vector<MessageValue>& list(std::string_view path) const;
  [[nodiscard]] const MessageValue& at(std::string_view path) const;
  /// Null where there is no such field.
  [[nodiscard]] const MessageValue* find(std::string_view path) const;
  [[nodiscard]] bool isStructure() const { return type_ != nullptr; }

 private:
  friend class MessageDecoder;

  template <typename Kind>
  const Kind& kindAt(std::string_view path, const char* expected) const
  {
    const Kind* value = std::get_if<Kind>(&at(path).value_);
    if (!value) failAt(path, expected);
    return *value;
  }
  [[noreturn]] static void failAt(std::string_view path, const char* expected);

  const MessageType* type_ = nullptr;  // of a structure, whose values are in the order of its fields
  std::variant<double, std::string, std::vector<double>, std::vector<MessageValue>> value_;
};

/// Decodes a message in CDR by its definition, which must outlive the result. Throws DamagedBytes for one that does not
/// fit its definition and for more than kMostValues values.
inline constexpr std::size_t kMostValues = 4'000'000;
[[nodiscard]] MessageValue decodeMessage(const MessageDefinition& definition, std::string_view message);
}  // namespace mrpt_ext
