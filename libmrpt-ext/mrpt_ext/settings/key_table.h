#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mrpt_ext/settings/key_choice.h"

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
  names,    ///< some of KeySpec::choices, separated by blanks or commas
};

/// Closed interval of allowed values; both ends may be infinite.
struct ValueRange
{
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// No number of an .ini file is larger, either way: what is computed from them stays finite, and ends.
inline constexpr double kLargestNumber = 1e9;

/// One key of an .ini file: its meaning, its allowed values and its default. KeySection (key_section.h) writes it in
/// one line. `section` may be a pattern: `Sensor_<label>` stands for every section that starts with Sensor_. The name
/// `*` accepts every key of the section as text (sections that are passed to MRPT).
struct KeySpec
{
  std::string section;
  std::string name;
  KeyType type = KeyType::text;
  std::string unit;           ///< empty: none
  std::string default_value;  ///< as in a file; empty: no default, the key stays unset
  ValueRange range;           ///< of number, integer and every one of numbers
  std::vector<KeyChoice> choices;
  std::string help;            ///< one or a few sentences; the first one is a summary of at most a line
  std::string alias = {};      ///< another name that files may use for it; empty: none
  bool for_beginners = false;  ///< one of the few keys to set first

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
  /// The spec for a key of an actual section, by its name or alias; a spec named by the key wins over `*`. Null when
  /// unknown.
  [[nodiscard]] const KeySpec* find(std::string_view section, std::string_view key) const;

  /// "unknown section [S], did you mean [T]?"
  [[nodiscard]] std::string unknownSection(std::string_view section) const;
  /// "unknown key 'k' in [S], did you mean 'l'?"
  [[nodiscard]] std::string unknownKey(std::string_view section, std::string_view key) const;

  /// Text of --list-keys: every section with its keys, default, unit and the first sentence of the help. At most 100
  /// columns wide.
  [[nodiscard]] std::string list() const;
  /// Text of --explain: `name` is Section.key, a section, or a key alone, which is explained in every section that has
  /// it. Throws InputError (configuration) with similar names when there is none.
  [[nodiscard]] std::string explain(const std::string& name) const;

 private:
  [[nodiscard]] std::string unknownName(const std::string& name) const;

  std::vector<KeySpec> keys_;
};

/// True if `section` is `pattern`, or fits it where the pattern has a <placeholder>.
[[nodiscard]] bool fitsPattern(std::string_view section, std::string_view pattern);
}  // namespace mrpt_ext
