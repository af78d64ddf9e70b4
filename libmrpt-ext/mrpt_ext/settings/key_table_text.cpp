#include <algorithm>
#include <sstream>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/key_table.h"

// The texts of --list-keys and --explain, from the same table that checks the files.
namespace mrpt_ext
{
namespace
{
void writeKeyLine(std::ostream& out, const KeySpec& key)
{
  out << "  " << key.name;
  if (!key.default_value.empty()) out << " = " << key.default_value;
  if (!key.unit.empty()) out << "  [" << key.unit << "]";
  if (key.name != "*") out << "  (" << key.expected() << ")";
  out << "\n";
}

void writeExplanation(std::ostream& out, const KeySpec& key)
{
  out << "[" << key.section << "] " << key.name << "\n  " << key.help << "\n  expected: " << key.expected() << "\n";
  out << "  default:  " << (key.default_value.empty() ? "none (not set)" : key.default_value) << "\n";
  for (const KeyChoice& choice : key.choices)
    if (choice.number) out << "  " << choice.name << " is " << *choice.number << " in MRPT's files\n";
}
}  // namespace

std::string KeyTable::list() const
{
  std::ostringstream out;
  for (const std::string& section : sections())
  {
    out << "[" << section << "]\n";
    for (const KeySpec& key : keys_)
      if (key.section == section) writeKeyLine(out, key);
  }
  return out.str();
}

std::string KeyTable::explain(const std::string& section_and_key) const
{
  std::ostringstream out;
  const std::size_t dot = section_and_key.rfind('.');
  const std::string section = section_and_key.substr(0, dot);
  const std::string name = dot == std::string::npos ? "" : section_and_key.substr(dot + 1);
  if (const KeySpec* key = find(section, name))
    writeExplanation(out, *key);
  else
    for (const KeySpec& one : keys_)
      if (fitsPattern(section_and_key, one.section)) writeExplanation(out, one);
  if (!out.str().empty()) return out.str();
  throw configurationError("--explain " + section_and_key + ": " +
                           (knowsSection(section) ? unknownKey(section, name) : unknownSection(section)));
}
}  // namespace mrpt_ext
