#include "mrpt_ext/settings/settings.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/trimmed.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/settings/setting_value.h"

namespace mrpt_ext
{
namespace fs = std::filesystem;

namespace
{
/// False for a value that would be cut off as a comment, or joined with the next line, when it is read again.
bool survivesAnIniFile(const std::string& value)
{
  if (value.find('\n') != std::string::npos) return false;
  const IniFile again = IniFile::parse("[section]\nkey = " + value + "\n", "");
  return again.find("section", "key")->value == trimmed(value);
}
}  // namespace

Settings Settings::load(const fs::path& file, KeyTable table, const std::vector<std::string>& overrides)
{
  return Settings(IniFile::read(file), file, std::move(table), overrides);
}

Settings Settings::parse(const std::string& text, const fs::path& name, KeyTable table,
                         const std::vector<std::string>& overrides)
{
  return Settings(IniFile::parse(text, name.string()), name, std::move(table), overrides);
}

Settings::Settings(IniFile ini, fs::path file, KeyTable table, const std::vector<std::string>& overrides)
    : ini_(std::move(ini)), file_(std::move(file)), table_(std::move(table))
{
  checkFile();
  resolveAliases();
  for (const std::string& text : overrides) applyOverride(text);
}

void Settings::checkFile() const
{
  for (const IniSection& section : ini_.sections())
  {
    const auto at = [&](int line) { return ini_.name() + ":" + std::to_string(line) + ": "; };
    if (!table_.knowsSection(section.name))
      throw configurationError(at(section.line) + table_.unknownSection(section.name));
    for (const IniEntry& entry : section.entries)
    {
      const KeySpec* spec = table_.find(section.name, entry.key);
      if (!spec) throw configurationError(at(entry.line) + table_.unknownKey(section.name, entry.key));
      if (const auto complaint = spec->complaintAbout(entry.value))
        throw configurationError(at(entry.line) + entry.key + " = " + entry.value + ": " + *complaint);
    }
  }
}

void Settings::resolveAliases()
{
  for (const KeySpec& spec : table_.keys())
    for (const IniSection& section : ini_.sections())
    {
      if (spec.alias.empty() || !fitsPattern(section.name, spec.section)) continue;
      const IniEntry* entry = section.find(spec.alias);
      if (!entry) continue;
      if (const IniEntry* other = section.find(spec.name))
        throw configurationError(ini_.name() + ":" + std::to_string(std::max(entry->line, other->line)) + ": " +
                                 spec.alias + " and " + spec.name + " are two names of one key, expected one of them");
      ini_.rename(section.name, spec.alias, spec.name);
    }
}

void Settings::applyOverride(const std::string& override_text)
{
  const std::string origin = "--set " + override_text;
  const std::size_t equals = override_text.find('=');
  const std::size_t dot = equals == std::string::npos ? equals : override_text.rfind('.', equals);
  if (dot == std::string::npos || dot == 0) throw configurationError(origin + ": expected Section.key=value");
  set(override_text.substr(0, dot), override_text.substr(dot + 1, equals - dot - 1), override_text.substr(equals + 1),
      origin);
}

void Settings::set(const std::string& section, const std::string& key, const std::string& value,
                   const std::string& origin)
{
  if (!table_.knowsSection(section)) throw configurationError(origin + ": " + table_.unknownSection(section));
  const KeySpec* spec = table_.find(section, key);
  if (!spec) throw configurationError(origin + ": " + table_.unknownKey(section, key));
  if (const auto complaint = spec->complaintAbout(value)) throw configurationError(origin + ": " + *complaint);
  const bool from_here = spec->type == KeyType::path && !value.empty();
  ini_.set(section, spec->name == "*" ? key : spec->name,
           from_here ? fs::absolute(value).lexically_normal().string() : value, origin);
}

const KeySpec& Settings::specOf(const std::string& section, const std::string& key) const
{
  const KeySpec* spec = table_.find(section, key);
  if (!spec) throw std::logic_error("key '" + key + "' of [" + section + "] is missing in the table of keys");
  return *spec;
}

std::optional<std::string> Settings::effective(const std::string& section, const std::string& key) const
{
  const KeySpec& spec = specOf(section, key);
  for (std::optional<std::string> from = section; from && fitsPattern(*from, spec.section);
       from = generalSection(*from))
    if (const IniEntry* entry = ini_.find(*from, key)) return entry->value;
  if (!spec.default_value.empty()) return spec.default_value;
  return std::nullopt;
}

std::optional<std::string> Settings::generalSection(const std::string& section) const
{
  for (std::size_t end = section.rfind('.'); end != std::string::npos && end > 0; end = section.rfind('.', end - 1))
  {
    std::string name = section.substr(0, end);
    if (hasSection(name)) return name;
  }
  return std::nullopt;
}

std::string Settings::required(const std::string& section, const std::string& key) const
{
  if (auto value = effective(section, key)) return *value;
  throw configurationError(ini_.name() + ": missing key '" + key + "' in [" + section + "], expected " +
                           specOf(section, key).expected());
}

bool Settings::isSet(const std::string& section, const std::string& key) const
{
  return ini_.find(section, key) != nullptr;
}

bool Settings::hasValue(const std::string& section, const std::string& key) const
{
  const auto value = effective(section, key);
  return value && !value->empty();
}

std::vector<std::string> Settings::sectionsMatching(const std::string& prefix) const
{
  std::vector<std::string> names;
  for (const IniSection& section : ini_.sections())
    if (section.name.starts_with(prefix)) names.push_back(section.name);
  return names;
}

double Settings::number(const std::string& section, const std::string& key) const
{
  return parseNumber(required(section, key)).value();
}

double Settings::radians(const std::string& section, const std::string& key) const
{
  return degToRad(number(section, key));
}

std::int64_t Settings::integer(const std::string& section, const std::string& key) const
{
  return parseWholeNumber(required(section, key)).value();
}

bool Settings::flag(const std::string& section, const std::string& key) const
{
  return parseFlag(required(section, key)).value();
}

std::string Settings::text(const std::string& section, const std::string& key) const { return required(section, key); }

fs::path Settings::path(const std::string& section, const std::string& key) const
{
  return (fs::absolute(file_).parent_path() / required(section, key)).lexically_normal();
}

fs::path Settings::existingPath(const std::string& section, const std::string& key) const
{
  fs::path file = path(section, key);
  if (!fs::exists(file)) throw dataError(originOf(section, key) + ": no such file " + file.string());
  return file;
}

std::string Settings::choice(const std::string& section, const std::string& key) const
{
  return parseChoice(required(section, key), specOf(section, key).choices).value();
}

std::vector<double> Settings::numbers(const std::string& section, const std::string& key) const
{
  return parseNumbers(required(section, key)).value();
}

std::vector<std::string> Settings::words(const std::string& section, const std::string& key) const
{
  return parseWords(effective(section, key).value_or(""));
}

std::optional<double> Settings::optionalNumber(const std::string& section, const std::string& key) const
{
  return hasValue(section, key) ? std::optional(number(section, key)) : std::nullopt;
}

std::optional<double> Settings::optionalRadians(const std::string& section, const std::string& key) const
{
  return hasValue(section, key) ? std::optional(radians(section, key)) : std::nullopt;
}

std::string Settings::originOf(const std::string& section, const std::string& key) const
{
  const IniEntry* entry = ini_.find(section, key);
  if (!entry) return ini_.name() + ": [" + section + "] " + key;
  if (entry->line == 0) return entry->origin;
  return ini_.name() + ":" + std::to_string(entry->line) + ": " + entry->key + " = " + entry->value;
}

InputError Settings::errorAt(const std::string& section, const std::string& key, const std::string& complaint) const
{
  return configurationError(originOf(section, key) + ": " + complaint);
}

void Settings::writeResolved(std::ostream& out, const std::string& section) const
{
  const auto write = [&](const std::string& key, const std::string& value)
  {
    if (!survivesAnIniFile(value))
      throw errorAt(section, key,
                    "'" + value +
                        "' cannot be written into config_resolved.ini, where a blank and then ; # or // begin a "
                        "comment: expected a value (or a folder of the configuration) without them");
    out << key << " = " << value << "\n";
  };
  out << "[" << section << "]\n";
  for (const KeySpec& spec : table_.keys())
  {
    if (!fitsPattern(section, spec.section) || spec.name == "*") continue;
    const bool from_general = !isSet(section, spec.name) && generalSection(section);
    if (from_general)
      out << "; " << spec.name << " as in [" << *generalSection(section) << "]\n";
    else if (!hasValue(section, spec.name))
      out << "; " << spec.name << " is not set\n";
    else if (spec.type == KeyType::path)
      write(spec.name, path(section, spec.name).string());
    else if (spec.type == KeyType::choice)
      write(spec.name, choice(section, spec.name));
    else
      write(spec.name, *effective(section, spec.name));
  }
  if (const IniSection* written = ini_.find(section))
    for (const IniEntry& entry : written->entries)
      if (table_.find(section, entry.key)->name == "*") write(entry.key, entry.value);
}

std::string Settings::resolvedText() const
{
  std::vector<std::string> sections;
  const auto addOnce = [&](const std::string& name)
  {
    if (std::find(sections.begin(), sections.end(), name) == sections.end()) sections.push_back(name);
  };
  for (const std::string& known : table_.sections())
  {
    if (known.find('<') == std::string::npos) addOnce(known);
    for (const IniSection& section : ini_.sections())
      if (fitsPattern(section.name, known)) addOnce(section.name);
  }
  std::ostringstream out;
  for (const std::string& section : sections) writeResolved(out, section);
  return out.str();
}
}  // namespace mrpt_ext
