#include "mrpt_ext/settings/key_section.h"

#include <charconv>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
std::string textOf(std::optional<double> value) { return value ? shortestText(*value) : std::string(); }

/// Degrees as they were written before they became radians: 0.3, not 0.30000000000000004.
std::string degreesText(std::optional<double> radians)
{
  if (!radians) return {};
  constexpr int kDigits = 12;
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof(text), radToDeg(*radians), std::chars_format::general, kDigits).ptr;
  return textOf(parseNumber({text, static_cast<std::size_t>(end - text)}));
}
}  // namespace

KeySection& KeySection::add(KeySpec key)
{
  key.section = section_;
  keys_.push_back(std::move(key));
  return *this;
}

KeySection& KeySection::number(const std::string& name, const std::string& unit, std::optional<double> default_value,
                               ValueRange range, const std::string& help)
{
  return add({{}, name, KeyType::number, unit, textOf(default_value), range, {}, help});
}

KeySection& KeySection::degrees(const std::string& name, const std::string& unit, std::optional<double> default_radians,
                                ValueRange range, const std::string& help)
{
  return add({{}, name, KeyType::number, unit, degreesText(default_radians), range, {}, help});
}

KeySection& KeySection::integer(const std::string& name, const std::string& unit,
                                std::optional<std::uint64_t> default_value, ValueRange range, const std::string& help)
{
  return add({{},
              name,
              KeyType::integer,
              unit,
              default_value ? std::to_string(*default_value) : std::string(),
              range,
              {},
              help});
}

KeySection& KeySection::numbers(const std::string& name, const std::string& unit,
                                const std::vector<double>& default_value, ValueRange range, const std::string& help)
{
  std::string text;
  for (const double value : default_value)
  {
    if (!text.empty()) text += ' ';
    text += shortestText(value);
  }
  return add({{}, name, KeyType::numbers, unit, text, range, {}, help});
}

KeySection& KeySection::flag(const std::string& name, bool default_value, const std::string& help)
{
  return add({{}, name, KeyType::flag, {}, default_value ? "true" : "false", {}, {}, help});
}

KeySection& KeySection::text(const std::string& name, const std::string& unit, const std::string& default_value,
                             const std::string& help)
{
  return add({{}, name, KeyType::text, unit, default_value, {}, {}, help});
}

KeySection& KeySection::path(const std::string& name, const std::string& help)
{
  return add({{}, name, KeyType::path, {}, {}, {}, {}, help});
}

KeySection& KeySection::choice(const std::string& name, const std::string& default_value,
                               std::vector<KeyChoice> choices, const std::string& help)
{
  return add({{}, name, KeyType::choice, {}, default_value, {}, std::move(choices), help});
}

KeySection& KeySection::names(const std::string& name, const std::string& default_value, std::vector<KeyChoice> choices,
                              const std::string& help)
{
  return add({{}, name, KeyType::names, {}, default_value, {}, std::move(choices), help});
}

KeySection& KeySection::alias(const std::string& name)
{
  keys_.back().alias = name;
  return *this;
}

KeySection& KeySection::forBeginners()
{
  keys_.back().for_beginners = true;
  return *this;
}
}  // namespace mrpt_ext
