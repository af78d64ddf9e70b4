#include "mrpt_ext/report/html_geometry.h"

#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
bool isShown(const MethodScore& method) { return !method.oracle && !method.errors.empty(); }

std::string cellText(const GeometryCell& cell)
{
  if (!cell.estimated || *cell.estimated == 0) return kNoNumber;
  return magnitudeText(cell.median) + element("small", "", percentText(cell.estimated));
}

std::string geometryTable(const ErrorsByGeometry& table, const RunScore& score)
{
  std::vector<std::string> titles{escapeHtml(table.quantity), "frames"};
  for (const MethodScore& method : score.methods)
    if (isShown(method)) titles.push_back(keyedName(method.name, methodNames(score.methods)));
  std::string rows;
  for (const GeometryClass& c : table.classes)
  {
    std::vector<std::string> cells{escapeHtml(c.label), std::to_string(c.frames)};
    for (std::size_t m = 0; m < c.methods.size(); ++m)
      if (isShown(score.methods[m])) cells.push_back(cellText(c.methods[m]));
    rows += htmlRow(cells);
  }
  return htmlTable(titles, rows, "geometry");
}
}  // namespace

std::string errorsByGeometrySection(const std::vector<ErrorsByGeometry>& tables, const RunScore& score)
{
  std::string html;
  for (std::size_t i = 0; i < tables.size(); ++i)
    html += element("h3", "", "By " + escapeHtml(tables[i].quantity)) + "\n" + chartBox("geometry", i) +
            geometryTable(tables[i], score);
  return html;
}
}  // namespace mrpt_ext
