#include "mrpt_ext/settings/ini_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "mrpt_ext/files/trimmed.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
/// A comment starts at ; # or // when it opens the line or follows a blank, so that paths and URLs stay whole.
std::string_view withoutComment(std::string_view line)
{
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const bool opens = i == 0 || kBlanks.find(line[i - 1]) != std::string_view::npos;
    if (opens && (line[i] == ';' || line[i] == '#' || line.substr(i, 2) == "//")) return line.substr(0, i);
  }
  return line;
}

/// As much of a line as a message needs.
std::string excerpt(const std::string& line)
{
  constexpr std::size_t kLongest = 100;
  return line.size() <= kLongest ? line : line.substr(0, kLongest) + "...";
}

/// Hands out logical lines: comments taken off, continued lines joined, numbered by their first physical line.
class LineReader
{
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}

  bool next(std::string& line, int& number)
  {
    line.clear();
    number = count_ + 1;
    bool any = false, continued = true;
    while (continued && !rest_.empty())
    {
      any = true;
      ++count_;
      const std::size_t end = rest_.find('\n');
      std::string_view physical = trimmed(withoutComment(rest_.substr(0, end)));
      rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
      continued = !physical.empty() && physical.back() == '\\';
      if (continued) physical = trimmed(physical.substr(0, physical.size() - 1));
      if (!line.empty() && !physical.empty()) line += ' ';
      line += physical;
    }
    return any;
  }

 private:
  std::string_view rest_;
  int count_ = 0;
};
}  // namespace

const IniEntry* IniSection::find(std::string_view key) const
{
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const IniEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

IniFile IniFile::read(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored) && std::filesystem::file_size(file, ignored) > kMostBytes)
    throw configurationError(file.string() + ": larger than " + std::to_string(kMostBytes >> 20) +
                             " MB, expected an .ini file");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!std::filesystem::is_regular_file(file) || !stream || !(text << stream.rdbuf()))
    throw configurationError(file.string() + ": cannot be read, expected an .ini file");
  return parse(text.str(), file.string());
}

IniFile IniFile::parse(std::string_view text, std::string name)
{
  IniFile ini;
  ini.name_ = std::move(name);
  if (text.find('\0') != std::string_view::npos)
    throw configurationError(ini.name_ + ": holds bytes that are no text, expected an .ini file");
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  LineReader lines(text);
  std::string line;
  for (int number = 0; lines.next(line, number);)
  {
    const auto fail = [&](const std::string& message)
    { return configurationError(ini.name_ + ":" + std::to_string(number) + ": " + message); };
    if (static_cast<std::size_t>(number) > kMostLines)
      throw fail("an .ini file of more than " + std::to_string(kMostLines) + " lines, expected a configuration");
    if (line.empty()) continue;
    if (line.front() == '[')
    {
      if (line.back() != ']' || line.size() < 3) throw fail("'" + excerpt(line) + "': expected [Section]");
      const std::string section(trimmed(std::string_view(line).substr(1, line.size() - 2)));
      if (const IniSection* earlier = ini.find(section))
        throw fail("section [" + section + "] is already in line " + std::to_string(earlier->line));
      if (ini.sections_.size() == kMostSections)
        throw fail("[" + excerpt(section) + "] is one section too many, expected at most " +
                   std::to_string(kMostSections));
      ini.sections_.push_back({section, number, {}});
      continue;
    }
    const std::size_t equals = line.find('=');
    const std::string key(trimmed(std::string_view(line).substr(0, equals)));
    if (equals == std::string::npos || key.empty()) throw fail("'" + excerpt(line) + "': expected key = value");
    if (ini.sections_.empty()) throw fail("'" + key + "' comes before the first [Section]");
    IniSection& section = ini.sections_.back();
    if (const IniEntry* earlier = section.find(key))
      throw fail("'" + key + "' in [" + section.name + "] is already in line " + std::to_string(earlier->line));
    section.entries.push_back({key, std::string(trimmed(std::string_view(line).substr(equals + 1))), number, {}});
  }
  return ini;
}

const IniSection* IniFile::find(std::string_view section) const
{
  const auto found =
      std::find_if(sections_.begin(), sections_.end(), [&](const IniSection& s) { return s.name == section; });
  return found == sections_.end() ? nullptr : &*found;
}

const IniEntry* IniFile::find(std::string_view section, std::string_view key) const
{
  const IniSection* found = find(section);
  return found ? found->find(key) : nullptr;
}

IniSection& IniFile::sectionNamed(const std::string& section)
{
  for (IniSection& known : sections_)
    if (known.name == section) return known;
  return sections_.emplace_back(IniSection{section, 0, {}});
}

void IniFile::set(const std::string& section, const std::string& key, const std::string& value,
                  const std::string& origin)
{
  const IniEntry given{key, value, 0, origin};
  IniSection& target = sectionNamed(section);
  const auto known = std::find_if(target.entries.begin(), target.entries.end(),
                                  [&](const IniEntry& entry) { return entry.key == key; });
  if (known == target.entries.end())
    target.entries.push_back(given);
  else
    *known = given;
}

void IniFile::rename(const std::string& section, const std::string& key, const std::string& new_key)
{
  for (IniEntry& entry : sectionNamed(section).entries)
    if (entry.key == key) entry.key = new_key;
}
}  // namespace mrpt_ext
