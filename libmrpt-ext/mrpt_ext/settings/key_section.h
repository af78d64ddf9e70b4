#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
inline constexpr std::nullopt_t kUnset = std::nullopt;  ///< a key without default

namespace ranges
{
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();
inline constexpr ValueRange kAny{}, kPositive{1e-9, kUnbounded}, kNotNegative{0, kUnbounded}, kShare{0, 1},
    kCount{1, 1e7};
}  // namespace ranges

/// Writes the keys of one section, a call per key:
///
///     KeySection("MotionModel").number("std_xy_per_m", "m", MotionModel{}.std_xy_per_m, kNotNegative, "...")
///
/// Defaults are values, so that they can be read from the struct that a section is turned into. Ranges are in the unit
/// of the key.
class KeySection
{
 public:
  explicit KeySection(std::string section) : section_(std::move(section)) {}

  KeySection& number(const std::string& name, const std::string& unit, std::optional<double> default_value,
                     ValueRange range, const std::string& help);
  /// A number whose default is in radians and whose value in files is in degrees; `unit` is deg, deg/s ...
  KeySection& degrees(const std::string& name, const std::string& unit, std::optional<double> default_radians,
                      ValueRange range, const std::string& help);
  KeySection& integer(const std::string& name, const std::string& unit, std::optional<std::uint64_t> default_value,
                      ValueRange range, const std::string& help);
  KeySection& numbers(const std::string& name, const std::string& unit, const std::vector<double>& default_value,
                      ValueRange range, const std::string& help);
  KeySection& flag(const std::string& name, bool default_value, const std::string& help);
  KeySection& text(const std::string& name, const std::string& unit, const std::string& default_value,
                   const std::string& help);
  KeySection& path(const std::string& name, const std::string& help);
  /// One of `choices`; an empty default leaves the key unset.
  KeySection& choice(const std::string& name, const std::string& default_value, std::vector<KeyChoice> choices,
                     const std::string& help);
  template <typename Value>
  KeySection& choice(const std::string& name, Value default_value, const NamedValues<Value>& values,
                     const std::string& help)
  {
    return choice(name, nameOf(default_value, values), choicesOf(values), help);
  }
  /// Some of `choices`.
  KeySection& names(const std::string& name, const std::string& default_value, std::vector<KeyChoice> choices,
                    const std::string& help);

  /// Files may call the last key so, too.
  KeySection& alias(const std::string& name);
  /// The last key is one of the few to set first.
  KeySection& forBeginners();

  /// The keys so far.
  operator KeyTable() const { return keys_; }  // NOLINT(google-explicit-constructor)

 private:
  KeySection& add(KeySpec key);

  std::string section_;
  std::vector<KeySpec> keys_;
};
}  // namespace mrpt_ext
