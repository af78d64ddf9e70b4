#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mrpt_ext
{
/// An allowed value of a key that takes one of a few names.
struct KeyChoice
{
  std::string name;
  std::optional<int> number = std::nullopt;  ///< what MRPT's own files write for it, where MRPT has one
  std::string help = {};                     ///< a few words, for --explain
};

/// The values of an enum under the names that files have for them: one table for the key and for its reader.
template <typename Value>
using NamedValues = std::vector<std::pair<Value, KeyChoice>>;

template <typename Value>
[[nodiscard]] std::vector<KeyChoice> choicesOf(const NamedValues<Value>& values)
{
  std::vector<KeyChoice> choices;
  for (const auto& [value, choice] : values) choices.push_back(choice);
  return choices;
}

/// The name of `value`, which must be in the table.
template <typename Value>
[[nodiscard]] std::string nameOf(const Value& value, const NamedValues<Value>& values)
{
  for (const auto& [known, choice] : values)
    if (known == value) return choice.name;
  return {};
}

/// The value with this name, which must be in the table.
template <typename Value>
[[nodiscard]] Value namedValue(const std::string& name, const NamedValues<Value>& values)
{
  for (const auto& [value, choice] : values)
    if (choice.name == name) return value;
  return values.front().first;
}
}  // namespace mrpt_ext
