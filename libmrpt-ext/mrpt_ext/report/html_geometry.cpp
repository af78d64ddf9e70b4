#include "mrpt_ext/report/html_geometry.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/svg_shapes.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWidth = 720, kHeight = 310, kLeft = 62, kRight = 12, kTop = 44, kBottom = 46;

/// Logarithmic axis of errors.
struct ErrorAxis
{
  double low = 0.01, high = 1;

  [[nodiscard]] double y(double error) const
  {
    const double share = std::log(std::clamp(error, low, high) / low) / std::log(high / low);
    return kHeight - kBottom - share * (kHeight - kTop - kBottom);
  }
};

bool isShown(const MethodScore& method) { return !method.oracle && !method.errors.empty(); }

ErrorAxis axisOf(const ErrorsByGeometry& table, const RunScore& score)
{
  double least = HUGE_VAL, most = 0;
  for (const GeometryClass& c : table.classes)
    for (std::size_t m = 0; m < c.methods.size(); ++m)
      if (isShown(score.methods[m]) && c.methods[m].median && *c.methods[m].median > 0)
      {
        least = std::min(least, *c.methods[m].median);
        most = std::max(most, *c.methods[m].p95);
      }
  if (!(most > 0)) return {};
  ErrorAxis axis{std::pow(10, std::floor(std::log10(least))), std::pow(10, std::ceil(std::log10(most)))};
  if (!(axis.high > axis.low)) axis.high = 10 * axis.low;
  axis.low = std::max(axis.low, axis.high * 1e-5);
  return axis;
}

std::string axes(const ErrorsByGeometry& table, const ErrorAxis& axis, double step)
{
  std::string svg;
  for (double v = axis.low; v < axis.high * 1.5; v *= 10)
    svg += svgLine({kLeft, axis.y(v)}, {kWidth - kRight, axis.y(v)}, "grid") +
           svgText({kLeft - 6, axis.y(v) + 4}, "end", "", niceText(v, std::min(v, 1.0))) + "\n";
  for (std::size_t c = 0; c < table.classes.size(); ++c)
    svg += svgText({kLeft + (static_cast<double>(c) + 0.5) * step, kHeight - kBottom + 18}, "middle", "",
                   table.classes[c].label);
  return svg + svgText({4, 15}, "start", "", "m, logarithmic") +
         svgText({kWidth - kRight, kHeight - 5}, "end", "", table.quantity) + "\n";
}

std::string drawing(const ErrorsByGeometry& table, const RunScore& score)
{
  const ErrorAxis axis = axisOf(table, score);
  const double step = (kWidth - kLeft - kRight) / static_cast<double>(table.classes.size());
  const auto shown = std::count_if(score.methods.begin(), score.methods.end(), isShown);
  std::string svg = "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + svgNumber(kWidth) + " " + svgNumber(kHeight) +
                    "\">" + element("title", "", escapeHtml("Position error against " + table.quantity)) + "\n" +
                    axes(table, axis, step);
  std::size_t place = 0;
  for (std::size_t m = 0; m < score.methods.size(); ++m)
  {
    if (!isShown(score.methods[m])) continue;
    const std::string colour = methodClass(score.methods[m].name, methodNames(score.methods));
    const double offset = (static_cast<double>(++place) - 0.5 * static_cast<double>(shown + 1)) *
                          std::min(14.0, 0.8 * step / static_cast<double>(shown));
    SvgPoints dots;
    for (std::size_t c = 0; c < table.classes.size(); ++c)
    {
      const GeometryCell& cell = table.classes[c].methods[m];
      if (!cell.median) continue;
      const double x = kLeft + (static_cast<double>(c) + 0.5) * step + offset;
      dots.emplace_back(x, axis.y(*cell.median));
      svg += svgLine({x, axis.y(*cell.median)}, {x, axis.y(*cell.p95)}, "whisker " + colour);
    }
    svg += svgDots(dots, "big " + colour);
  }
  return svg + "</svg>\n";
}

std::string cellText(const GeometryCell& cell)
{
  if (!cell.answered || *cell.answered == 0) return kNoNumber;
  return magnitudeText(cell.median) + element("small", "", percentText(cell.answered));
}

std::string table(const ErrorsByGeometry& table, const RunScore& score)
{
  std::string head = "<th scope=\"col\">" + escapeHtml(table.quantity) + "</th><th scope=\"col\">frames</th>", rows;
  for (const MethodScore& method : score.methods)
    if (isShown(method))
      head += "<th scope=\"col\">" +
              element("span", "key dot " + methodClass(method.name, methodNames(score.methods)), "") +
              breakableName(method.name) + "</th>";
  for (const GeometryClass& c : table.classes)
  {
    std::string row =
        "<th scope=\"row\">" + escapeHtml(c.label) + "</th>" + element("td", "", std::to_string(c.frames));
    for (std::size_t m = 0; m < c.methods.size(); ++m)
      if (isShown(score.methods[m])) row += element("td", "", cellText(c.methods[m]));
    rows += element("tr", "", row) + "\n";
  }
  const std::string body = element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", "\n" + rows);
  return element("div", "scroll", element("table", "geometry", "\n" + body)) + "\n";
}
}  // namespace

std::string errorsByGeometrySection(const std::vector<ErrorsByGeometry>& tables, const RunScore& score)
{
  std::string html;
  for (const ErrorsByGeometry& errors : tables)
    html += element("h3", "", "Against " + escapeHtml(errors.quantity)) + "\n" + drawing(errors, score) +
            table(errors, score);
  return html;
}
}  // namespace mrpt_ext
