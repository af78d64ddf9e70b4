#include <algorithm>
#include <sstream>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/settings/key_table.h"
#include "mrpt_ext/settings/name_suggestion.h"
#include "mrpt_ext/settings/setting_value.h"

// The texts of --list-keys and --explain, from the same table that checks the files.
namespace mrpt_ext
{
namespace
{
constexpr std::size_t kWidth = 100;      // columns of the whole text
constexpr std::size_t kHelpColumn = 42;  // where the help begins in the list

/// `head`, then `text` from `column` on, broken between words at kWidth.
void writeWrapped(std::ostream& out, std::string head, std::size_t column, const std::string& text)
{
  std::string line = std::move(head);
  std::istringstream words(text);
  bool begins = true;
  for (std::string word; words >> word; begins = false)
  {
    const std::size_t start = begins ? std::max(column, line.size() + 2) : line.size() + 1;
    const bool fits = start + word.size() <= kWidth;
    if (!fits) out << line << '\n', line.clear();
    line.resize(fits ? start : column, ' ');
    line += word;
  }
  out << line << '\n';
}

std::string firstSentence(const std::string& help)
{
  const std::size_t end = help.find(". ");
  return end == std::string::npos ? help : help.substr(0, end + 1);
}

void writeKeyLine(std::ostream& out, const KeySpec& key)
{
  std::string head = std::string(key.for_beginners ? "* " : "  ") + (key.name == "*" ? "(any key)" : key.name);
  if (!key.default_value.empty()) head += " = " + key.default_value;
  if (!key.unit.empty()) head += ' ' + (key.default_value.empty() ? '[' + key.unit + ']' : key.unit);
  writeWrapped(out, head, kHelpColumn, firstSentence(key.help));
}

void writeChoices(std::ostream& out, const std::vector<KeyChoice>& choices)
{
  std::size_t widest = 0;
  for (const KeyChoice& choice : choices) widest = std::max(widest, choice.name.size());
  for (const KeyChoice& choice : choices)
  {
    std::string help = choice.help;
    if (choice.number) help += (help.empty() ? "" : "; ") + std::to_string(*choice.number) + " in MRPT's files";
    writeWrapped(out, "    " + choice.name, widest + 6, help);
  }
}

void writeExplanation(std::ostream& out, const KeySpec& key)
{
  out << '[' << key.section << "] " << key.name << '\n';
  writeWrapped(out, "", 2, key.help);
  out << "  default:  " << (key.default_value.empty() ? "none (not set)" : key.default_value);
  if (!key.default_value.empty() && !key.unit.empty()) out << ' ' << key.unit;
  out << '\n';
  if (key.choices.empty())
    out << "  expected: " << key.expected() << '\n';
  else
    out << (key.type == KeyType::names ? "  expected: some of these, separated by blanks or commas\n"
                                       : "  expected: one of\n");
  writeChoices(out, key.choices);
  if (!key.alias.empty()) out << "  also read as " << key.alias << '\n';
}
}  // namespace

std::string KeyTable::list() const
{
  std::ostringstream out;
  if (std::any_of(keys_.begin(), keys_.end(), [](const KeySpec& key) { return key.for_beginners; }))
    out << "Every key with its default and unit. Keys marked * are the ones to set first.\n"
           "--explain KEY shows a key in full.\n\n";
  for (const std::string& section : sections())
  {
    out << '[' << section << "]\n";
    for (const KeySpec& key : keys_)
      if (key.section == section) writeKeyLine(out, key);
  }
  return out.str();
}

std::string KeyTable::explain(const std::string& name) const
{
  std::ostringstream out;
  const std::size_t dot = name.rfind('.');
  if (const KeySpec* key = dot == std::string::npos ? nullptr : find(name.substr(0, dot), name.substr(dot + 1)))
    writeExplanation(out, *key);
  else
    for (const KeySpec& one : keys_)
      if (fitsPattern(name, one.section) || one.name == name || (!one.alias.empty() && one.alias == name))
        writeExplanation(out, one);
  if (out.str().empty()) throw configurationError("--explain " + name + ": " + unknownName(name));
  return out.str();
}

std::string KeyTable::unknownName(const std::string& name) const
{
  const std::size_t dot = name.rfind('.');
  const std::string section = name.substr(0, dot), key = dot == std::string::npos ? name : name.substr(dot + 1);
  if (dot != std::string::npos && knowsSection(section)) return unknownKey(section, key);
  std::vector<std::string> names;
  for (const KeySpec& known : keys_)
    if (std::find(names.begin(), names.end(), known.name) == names.end()) names.push_back(known.name);
  if (dot == std::string::npos)
    for (const std::string& known : sections()) names.push_back(known);
  std::string near;
  for (const std::string& similar : similarNames(key, names))
    near += (near.empty() ? "" : ", ") + ("'" + similar + "'");
  return "unknown key or section" +
         (near.empty() ? ", --list-keys shows the known ones" : ", did you mean " + near + "?");
}
}  // namespace mrpt_ext
