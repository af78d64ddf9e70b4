#include "mrpt_ext/report/html_parts.h"

#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/page_assets.h"

namespace mrpt_ext
{
namespace
{
/// The page may use what is in it, and request nothing.
constexpr const char* kOffline = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
}  // namespace

std::string htmlRow(const std::vector<std::string>& cells, std::string_view css_class)
{
  std::string html = "<th scope=\"row\">" + cells.front() + "</th>";
  for (std::size_t c = 1; c < cells.size(); ++c) html += element("td", "", cells[c]);
  return element("tr", css_class, html) + "\n";
}

std::string htmlTable(const std::vector<std::string>& titles, const std::string& rows, std::string_view css_class)
{
  std::string head;
  for (const std::string& title : titles) head += "<th scope=\"col\">" + title + "</th>";
  const std::string body = element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", "\n" + rows);
  return element("div", "scroll", element("table", css_class, "\n" + body)) + "\n";
}

std::string htmlSection(const std::string& title, const std::string& content, const std::string& note)
{
  if (content.empty()) return {};
  const std::string explanation = note.empty() ? "" : element("p", "note", note) + "\n";
  return element("section", "", element("h2", "", title) + "\n" + content + explanation) + "\n";
}

std::string chartBox(const std::string& name, std::size_t index)
{
  const std::string note = element("p", "note", "This chart needs JavaScript.");
  return "<div data-chart=\"" + name + "\" data-index=\"" + std::to_string(index) + "\">" +
         element("noscript", "", note) + "</div>\n";
}

std::string htmlPage(const std::string& title, const std::string& subtitle, const std::string& body,
                     const std::string& scripts)
{
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      std::string(kOffline) + "\"/>\n" + element("title", "", escapeHtml(title)) + "\n" +
      element("style", "", "\n" + std::string(pageStyle()));
  const std::string header =
      element("header", "", element("h1", "", escapeHtml(title)) + element("p", "note", escapeHtml(subtitle))) + "\n";
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("head", "", "\n" + head + "\n") + "\n" +
         element("body", "", "\n" + element("main", "", "\n" + header + body) + "\n" + scripts) + "\n</html>\n";
}
}  // namespace mrpt_ext
