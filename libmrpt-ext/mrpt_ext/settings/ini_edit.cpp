#include "mrpt_ext/settings/ini_edit.h"

#include <algorithm>
#include <sstream>

#include "mrpt_ext/files/trimmed.h"

namespace mrpt_ext
{
namespace
{
std::string_view keyOf(std::string_view line)
{
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || trimmed(line).starts_with(';')) return {};
  return trimmed(line.substr(0, equals));
}

/// The line with another value, its comment kept.
std::string withValue(const std::string& line, const std::string& value)
{
  const std::size_t equals = line.find('='), comment = line.find(';', equals);
  std::string result = line.substr(0, equals + 1) + ' ' + value;
  if (comment != std::string::npos) (result += ' ') += line.substr(comment);
  return result;
}

void setLine(std::vector<std::string>& text, const IniAssignment& wanted)
{
  const auto header = std::find_if(
      text.begin(), text.end(), [&](const std::string& line) { return trimmed(line) == '[' + wanted.section + ']'; });
  if (header == text.end())
  {
    text.insert(text.end(), {"", '[' + wanted.section + ']', wanted.key + " = " + wanted.value});
    return;
  }
  auto last = header;
  for (auto line = header + 1; line != text.end() && !trimmed(*line).starts_with('['); ++line)
  {
    if (keyOf(*line) == wanted.key)
    {
      *line = withValue(*line, wanted.value);
      return;
    }
    if (!keyOf(*line).empty()) last = line;
  }
  text.insert(last + 1, wanted.key + " = " + wanted.value);
}
}  // namespace

std::string withValues(const std::string& ini, const std::vector<IniAssignment>& lines)
{
  std::vector<std::string> text;
  std::istringstream in(ini);
  for (std::string line; std::getline(in, line);) text.push_back(line);
  for (const IniAssignment& line : lines) setLine(text, line);
  std::string result;
  for (const std::string& line : text) result += line + '\n';
  return result;
}
}  // namespace mrpt_ext
