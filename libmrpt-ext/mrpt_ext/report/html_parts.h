#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
/// Parts that the pages share. Arguments are HTML unless said otherwise.

/// A row of a table; the first cell is its heading.
[[nodiscard]] std::string htmlRow(const std::vector<std::string>& cells, std::string_view css_class = "");
/// A table in a box that scrolls sideways where the screen is narrow.
[[nodiscard]] std::string htmlTable(const std::vector<std::string>& titles, const std::string& rows,
                                    std::string_view css_class = "");
/// A section with an explaining note below its content. Empty without content.
[[nodiscard]] std::string htmlSection(const std::string& title, const std::string& content,
                                      const std::string& note = "");
/// Box in which the scripts draw a chart; without scripts a note that charts need them. `index`: of several charts of a
/// name.
[[nodiscard]] std::string chartBox(const std::string& name, std::size_t index = 0);
/// A whole page that requests nothing from outside. `title` and `subtitle` are plain text.
[[nodiscard]] std::string htmlPage(const std::string& title, const std::string& subtitle, const std::string& body,
                                   const std::string& scripts = "");
}  // namespace mrpt_ext
