#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
enum class KeyType
{
  number,
  integer,
  flag,     ///< true/false, yes/no, on/off, 1/0
  text,     ///< anything, kept verbatim
  path,     ///< file or folder, relative to the .ini
  choice,   ///< one of KeySpec::choices, by name or by MRPT's number
  numbers,  ///< numbers separated by blanks or commas
};

/// A value of a choice; `number` is what MRPT's own files write for it, where MRPT has one.
struct KeyChoice
{
  std::string name;
  std::optional<int> number;
};

/// Closed interval of allowed values; both ends may be infinite.
struct ValueRange
{
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// One key of an .ini file: what it means, what it may be and what it is when nobody sets it. Meant to be written with
/// designated initializers. `section` may be a pattern: `Sensor_<label>` stands for every section that starts with
/// Sensor_. The name `*` accepts every key of the section as text (sections that are handed on to MRPT).
struct KeySpec
{
  std::string section;
  std::string name;
  KeyType type = KeyType::text;
  std::string unit;           ///< empty: none
  std::string default_value;  ///< as in a file; empty: no default, the key stays unset
  ValueRange range;           ///< of number, integer and every one of numbers
  std::vector<KeyChoice> choices;
  std::string help;  ///< one or a few sentences

  /// What a value has to look like, e.g. "a number in [0, 360] deg".
  [[nodiscard]] std::string expected() const;
  /// Nothing when `value` is acceptable, else what is expected.
  [[nodiscard]] std::optional<std::string> complaintAbout(const std::string& value) const;
};

/// All keys an app knows, in the order in which they are listed.
class KeyTable
{
 public:
  KeyTable() = default;
  KeyTable(std::vector<KeySpec> keys) : keys_(std::move(keys)) {}  // NOLINT(google-explicit-constructor)

  /// Adds the keys of another table behind these.
  KeyTable& append(const KeyTable& more);

  [[nodiscard]] const std::vector<KeySpec>& keys() const { return keys_; }
  /// Section names and patterns, each once, in order.
  [[nodiscard]] std::vector<std::string> sections() const;
  [[nodiscard]] bool knowsSection(std::string_view section) const;
  /// The spec for a key of an actual section; a spec named by the key wins over `*`. Null when unknown.
  [[nodiscard]] const KeySpec* find(std::string_view section, std::string_view key) const;

  /// "unknown section [S], did you mean [T]?"
  [[nodiscard]] std::string unknownSection(std::string_view section) const;
  /// "unknown key 'k' in [S], did you mean 'l'?"
  [[nodiscard]] std::string unknownKey(std::string_view section, std::string_view key) const;

  /// Text of --list-keys: every section with its keys, default and unit.
  [[nodiscard]] std::string list() const;
  /// Text of --explain Section.key, or of a whole section; throws InputError (configuration) for an unknown one.
  [[nodiscard]] std::string explain(const std::string& section_and_key) const;

 private:
  std::vector<KeySpec> keys_;
};

/// True if `section` is `pattern`, or fits it where the pattern has a <placeholder>.
[[nodiscard]] bool fitsPattern(std::string_view section, std::string_view pattern);
}  // namespace mrpt_ext
