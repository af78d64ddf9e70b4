#include "mrpt_ext/report/html_text.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
constexpr std::string_view kOraclePrefix = "oracle_";
constexpr std::size_t kFormColours = 6;

std::string withoutOracle(const std::string& name)
{
  return name.starts_with(kOraclePrefix) ? name.substr(kOraclePrefix.size()) : name;
}

std::string ownColour(const std::string& name)
{
  if (name == "particle_filter") return "filter";
  if (name == "extended_kalman_filter") return "ekf";
  if (name == "odometry") return "odometry";
  return {};
}
}  // namespace

std::string escapeHtml(std::string_view text)
{
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text)
  {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (c == '\'')
      safe += "&#39;";
    else
      safe += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
  }
  return safe;
}

std::string breakableName(std::string_view name)
{
  std::string html;
  for (const char c : escapeHtml(name)) html += c == '_' ? std::string("_<wbr/>") : std::string(1, c);
  return html;
}

std::string element(std::string_view tag, std::string_view css_class, std::string_view content)
{
  std::string html = "<" + std::string(tag);
  if (!css_class.empty()) html += " class=\"" + std::string(css_class) + "\"";
  return html + ">" + std::string(content) + "</" + std::string(tag) + ">";
}

std::string methodClass(const std::string& name, const std::vector<std::string>& names)
{
  const std::string base = withoutOracle(name);
  if (const std::string own = ownColour(base); !own.empty()) return own;
  std::vector<std::string> forms;
  for (const std::string& other : names)
    if (const std::string form = withoutOracle(other);
        ownColour(form).empty() && std::find(forms.begin(), forms.end(), form) == forms.end())
      forms.push_back(form);
  const auto index = static_cast<std::size_t>(std::find(forms.begin(), forms.end(), base) - forms.begin());
  return "form-" + std::to_string(index % kFormColours + 1);
}

std::string keyedName(const std::string& name, const std::vector<std::string>& names)
{
  return element("span", "key dot " + methodClass(name, names), "") + breakableName(name);
}

std::vector<std::string> methodNames(const std::vector<MethodScore>& methods)
{
  std::vector<std::string> names;
  for (const MethodScore& method : methods) names.push_back(method.name);
  return names;
}

std::string htmlLegend(const std::vector<LegendEntry>& entries)
{
  std::string items;
  for (const LegendEntry& entry : entries)
    items +=
        element("li", "", element("span", "key " + entry.symbol + " " + entry.css_class, "") + escapeHtml(entry.label));
  return element("ul", "legend", items) + "\n";
}
}  // namespace mrpt_ext
