#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
/// One `key = value` with where it was written.
struct IniEntry
{
  std::string key;
  std::string value;        ///< verbatim, without surrounding blanks and trailing comment
  int line = 0;             ///< in the file; 0: not written there
  std::string origin = {};  ///< the option that gave it instead, e.g. "--map my.csv"
};

struct IniSection
{
  std::string name;
  int line = 0;
  std::vector<IniEntry> entries;

  [[nodiscard]] const IniEntry* find(std::string_view key) const;
};

/// An .ini file in MRPT's form, read strictly: `[Section]`, `key = value`, comments after ; # or // (at the start of a
/// line or after a blank), a backslash at the end of a line continues the value. A key before the first section, a key
/// or a section written twice, and a line that is none of these are InputErrors (configuration) with file and line, and
/// so are more sections, lines or bytes than anybody writes.
class IniFile
{
 public:
  static constexpr std::size_t kMostSections = 1000, kMostLines = 20'000, kMostBytes = 4 << 20;

  /// Throws InputError (configuration) when the file cannot be read.
  static IniFile read(const std::filesystem::path& file);
  /// `name` stands for the file in error messages.
  static IniFile parse(std::string_view text, std::string name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<IniSection>& sections() const { return sections_; }
  [[nodiscard]] const IniSection* find(std::string_view section) const;
  [[nodiscard]] const IniEntry* find(std::string_view section, std::string_view key) const;
  /// Adds or replaces an entry; `origin` names the option that it comes from.
  void set(const std::string& section, const std::string& key, const std::string& value, const std::string& origin);
  /// Gives an entry another key.
  void rename(const std::string& section, const std::string& key, const std::string& new_key);

 private:
  IniSection& sectionNamed(const std::string& section);

  std::string name_;
  std::vector<IniSection> sections_;
};
}  // namespace mrpt_ext
