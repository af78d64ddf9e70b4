#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/ini_file.h"
#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
/// An .ini file checked against a table of keys, with the changes of --set on top. Every mistake in it is found at
/// loading and reported as InputError (configuration), `file:line: ...` or `--set Section.key=value: ...`.
///
/// A section with a label ([Sensor_<label>]) inherits the keys that it does not set from a more general one in the
/// file, whose name it continues after a dot: [Sensor_camera.4] from [Sensor_camera].
///
/// The getters return the effective value: set in the file or by --set, else the table's default. Without either they
/// throw an InputError that names the missing key; check with `hasValue` first. Asking for a key that is not in the
/// table is a programmer's mistake (std::logic_error). Aliases are resolved at loading: getters take a key's name.
class Settings
{
 public:
  /// `overrides` hold "Section.key=value" each; a relative path in them counts from the current folder.
  static Settings load(const std::filesystem::path& file, KeyTable table,
                       const std::vector<std::string>& overrides = {});
  /// The same from text; `name` stands for the file in messages, its folder is where relative paths count from.
  static Settings parse(const std::string& text, const std::filesystem::path& name, KeyTable table,
                        const std::vector<std::string>& overrides = {});

  /// Changes a value from code (an option of the command line); checked like --set. `origin` is the option as given,
  /// "--map my.csv"; it begins every message about this value.
  void set(const std::string& section, const std::string& key, const std::string& value, const std::string& origin);

  /// The keys that it was checked against.
  [[nodiscard]] const KeyTable& table() const { return table_; }
  /// True if the file or --set gives the key a value.
  [[nodiscard]] bool isSet(const std::string& section, const std::string& key) const;
  /// True if there is an effective value that is not empty.
  [[nodiscard]] bool hasValue(const std::string& section, const std::string& key) const;
  [[nodiscard]] bool hasSection(const std::string& section) const { return ini_.find(section) != nullptr; }
  /// The section that this one inherits from.
  [[nodiscard]] std::optional<std::string> generalSection(const std::string& section) const;
  /// Names of the sections present that start with `prefix`, in the order of the file.
  [[nodiscard]] std::vector<std::string> sectionsMatching(const std::string& prefix) const;

  [[nodiscard]] double number(const std::string& section, const std::string& key) const;
  /// A `_deg` key in radians.
  [[nodiscard]] double radians(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::int64_t integer(const std::string& section, const std::string& key) const;
  [[nodiscard]] bool flag(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& section, const std::string& key) const;
  /// Absolute path.
  [[nodiscard]] std::filesystem::path path(const std::string& section, const std::string& key) const;
  /// Absolute path of a file that has to exist; throws InputError (data) that names the key or option otherwise.
  [[nodiscard]] std::filesystem::path existingPath(const std::string& section, const std::string& key) const;
  /// Name of the choice, also where the file has MRPT's number.
  [[nodiscard]] std::string choice(const std::string& section, const std::string& key) const;
  /// The value of the choice.
  template <typename Value>
  [[nodiscard]] Value choice(const std::string& section, const std::string& key, const NamedValues<Value>& values) const
  {
    return namedValue(choice(section, key), values);
  }
  /// The words of a text, separated by blanks or commas; none where it is not set.
  [[nodiscard]] std::vector<std::string> words(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::optional<double> optionalNumber(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::optional<double> optionalRadians(const std::string& section, const std::string& key) const;

  /// An error about this key, found where it is used: "file:line: key = value: <complaint>", or with the option that
  /// gave the value, "--set Section.key=value: <complaint>".
  [[nodiscard]] InputError errorAt(const std::string& section, const std::string& key,
                                   const std::string& complaint) const;

  /// config_resolved.ini: every key with its effective value, paths absolute; loads again to the same settings.
  [[nodiscard]] std::string resolvedText() const;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  Settings(IniFile ini, std::filesystem::path file, KeyTable table, const std::vector<std::string>& overrides);

  void checkFile() const;
  void resolveAliases();
  void applyOverride(const std::string& override_text);
  [[nodiscard]] const KeySpec& specOf(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::optional<std::string> effective(const std::string& section, const std::string& key) const;
  [[nodiscard]] std::string required(const std::string& section, const std::string& key) const;
  /// Where the value of a key comes from, as the beginning of a message.
  [[nodiscard]] std::string originOf(const std::string& section, const std::string& key) const;
  void writeResolved(std::ostream& out, const std::string& section) const;

  IniFile ini_;
  std::filesystem::path file_;
  KeyTable table_;
};
}  // namespace mrpt_ext
