#include "mrpt_ext/settings/key_table.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/settings/name_suggestion.h"
#include "mrpt_ext/settings/setting_value.h"

namespace mrpt_ext
{
namespace
{
std::string plain(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string intervalText(const ValueRange& range)
{
  if (std::isfinite(range.low) && std::isfinite(range.high))
    return " in [" + plain(range.low) + ", " + plain(range.high) + "]";
  if (std::isfinite(range.low)) return " of at least " + plain(range.low);
  if (std::isfinite(range.high)) return " of at most " + plain(range.high);
  return {};
}

std::string choiceNames(const std::vector<KeyChoice>& choices)
{
  std::string text;
  for (const KeyChoice& choice : choices) text += (text.empty() ? "" : " | ") + choice.name;
  return text;
}

std::optional<std::string> complaintAboutNames(const std::string& value, const std::vector<KeyChoice>& choices)
{
  std::vector<std::string> known;
  for (const KeyChoice& choice : choices) known.push_back(choice.name);
  for (const std::string& name : parseWords(value))
  {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto near = closestName(name, known);
    return "unknown name '" + name + "', " +
           (near ? "did you mean '" + *near + "'?" : "expected some of " + choiceNames(choices));
  }
  return std::nullopt;
}

bool inside(const ValueRange& range, double value)
{
  return value >= range.low && value <= range.high && std::abs(value) <= kLargestNumber;
}

/// For values that are numbers, but larger than any meaning.
std::string hugeNumberText(const std::string& value)
{
  for (const double number : parseNumbers(value).value_or(std::vector<double>{}))
    if (std::abs(number) > kLargestNumber) return ", and none beyond " + plain(kLargestNumber);
  return {};
}
}  // namespace

std::string KeySpec::expected() const
{
  const std::string of_unit = unit.empty() ? "" : " " + unit;
  switch (type)
  {
    case KeyType::number:
      return "a number" + intervalText(range) + of_unit;
    case KeyType::integer:
      return "a whole number" + intervalText(range) + of_unit;
    case KeyType::flag:
      return "true or false";
    case KeyType::text:
      return "a text";
    case KeyType::path:
      return "a path, relative to the .ini";
    case KeyType::choice:
      return choiceNames(choices);
    case KeyType::numbers:
      return "numbers separated by blanks, each" + (intervalText(range).empty() ? " finite" : intervalText(range)) +
             of_unit;
    case KeyType::names:
      return "some of " + choiceNames(choices);
  }
  return {};
}

std::optional<std::string> KeySpec::complaintAbout(const std::string& value) const
{
  bool good = true;
  if (type == KeyType::number)
  {
    const auto number = parseNumber(value);
    good = number && inside(range, *number);
  }
  else if (type == KeyType::integer)
  {
    const auto integer = parseWholeNumber(value);
    good = integer && static_cast<double>(*integer) >= range.low && static_cast<double>(*integer) <= range.high;
  }
  else if (type == KeyType::flag)
    good = parseFlag(value).has_value();
  else if (type == KeyType::choice)
    good = parseChoice(value, choices).has_value();
  else if (type == KeyType::numbers)
  {
    const auto numbers = parseNumbers(value);
    good = numbers && std::all_of(numbers->begin(), numbers->end(), [&](double v) { return inside(range, v); });
  }
  else if (type == KeyType::names)
    return complaintAboutNames(value, choices);
  if (good) return std::nullopt;
  const bool real = type == KeyType::number || type == KeyType::numbers;
  return "expected " + expected() + (real ? hugeNumberText(value) : "");
}

bool fitsPattern(std::string_view section, std::string_view pattern)
{
  const std::size_t open = pattern.find('<');
  if (open == std::string_view::npos) return section == pattern;
  const std::string_view before = pattern.substr(0, open), after = pattern.substr(pattern.find('>') + 1);
  return section.size() > before.size() + after.size() && section.starts_with(before) && section.ends_with(after);
}

KeyTable& KeyTable::append(const KeyTable& more)
{
  keys_.insert(keys_.end(), more.keys_.begin(), more.keys_.end());
  return *this;
}

std::vector<std::string> KeyTable::sections() const
{
  std::vector<std::string> names;
  for (const KeySpec& key : keys_)
    if (std::find(names.begin(), names.end(), key.section) == names.end()) names.push_back(key.section);
  return names;
}

bool KeyTable::knowsSection(std::string_view section) const
{
  return std::any_of(keys_.begin(), keys_.end(), [&](const KeySpec& k) { return fitsPattern(section, k.section); });
}

const KeySpec* KeyTable::find(std::string_view section, std::string_view key) const
{
  const KeySpec* any = nullptr;
  for (const KeySpec& spec : keys_)
  {
    if (!fitsPattern(section, spec.section)) continue;
    if (spec.name == key || (!spec.alias.empty() && spec.alias == key)) return &spec;
    if (spec.name == "*") any = &spec;
  }
  return any;
}

std::string KeyTable::unknownSection(std::string_view section) const
{
  const std::vector<std::string> names = sections();
  const std::string message = "unknown section [" + std::string(section) + "]";
  if (const auto near = closestName(section, names)) return message + ", did you mean [" + *near + "]?";
  for (const std::string& name : names)
    if (const std::size_t open = name.find('<'); open != std::string::npos && open > 0)
      if (closestName(section.substr(0, open), {name.substr(0, open)}))
        return message + ", did you mean [" + name + "]?";
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return message + ", expected one of " + all;
}

std::string KeyTable::unknownKey(std::string_view section, std::string_view key) const
{
  std::vector<std::string> here;
  std::string elsewhere;
  for (const KeySpec& spec : keys_)
  {
    if (fitsPattern(section, spec.section)) here.push_back(spec.name);
    if (spec.name == key) elsewhere = spec.section;
  }
  const std::string message = "unknown key '" + std::string(key) + "' in [" + std::string(section) + "]";
  if (!elsewhere.empty()) return message + ", it belongs in [" + elsewhere + "]";
  if (const auto near = closestName(key, here)) return message + ", did you mean '" + *near + "'?";
  return message + ", --list-keys shows the known ones";
}
}  // namespace mrpt_ext
