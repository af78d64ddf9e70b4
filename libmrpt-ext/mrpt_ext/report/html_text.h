#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Text made safe for HTML content and attribute values; control characters become blanks.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// Like escapeHtml(), with optional line breaks after underscores.
[[nodiscard]] std::string breakableName(std::string_view name);

/// `<tag class="css_class">content</tag>`; `content` is HTML already, an empty class is left out.
[[nodiscard]] std::string element(std::string_view tag, std::string_view css_class, std::string_view content);

/// CSS class that gives a method its colour: filter, ekf, odometry, or form-1 ... form-6 for closed forms in the order
/// of `names`. An oracle has the colour of its method.
[[nodiscard]] std::string methodClass(const std::string& name, const std::vector<std::string>& names);

/// Name of a method with a dot of its colour.
[[nodiscard]] std::string keyedName(const std::string& name, const std::vector<std::string>& names);

/// Names of the methods, in their order.
[[nodiscard]] std::vector<std::string> methodNames(const std::vector<MethodScore>& methods);

/// Entry of a legend.
struct LegendEntry
{
  std::string css_class;
  std::string symbol;  ///< line, dash, dot, triangle, ring, square
  std::string label;
};
[[nodiscard]] std::string htmlLegend(const std::vector<LegendEntry>& entries);
}  // namespace mrpt_ext
