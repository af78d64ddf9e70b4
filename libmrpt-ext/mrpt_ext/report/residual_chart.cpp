#include "mrpt_ext/report/residual_chart.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/landmark_quality.h"
#include "mrpt_ext/report/svg_shapes.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWidth = 720, kHeight = 260, kLeft = 46, kRight = 12, kTop = 40, kBottom = 40;
constexpr std::size_t kMaxLandmarks = 120, kMaxNames = 30;

double heightOf(double sigmas, double reach)
{
  const double middle = 0.5 * (kTop + kHeight - kBottom);
  return middle - std::clamp(sigmas / reach, -1.0, 1.0) * 0.5 * (kHeight - kTop - kBottom);
}

std::string frame(double reach)
{
  std::string svg = "<rect class=\"band\" x=\"" + svgNumber(kLeft) + "\" y=\"" + svgNumber(heightOf(1, reach)) +
                    "\" width=\"" + svgNumber(kWidth - kLeft - kRight) + "\" height=\"" +
                    svgNumber(heightOf(-1, reach) - heightOf(1, reach)) + "\"/>\n";
  for (double v = -reach; v <= reach + 0.01; v += reach / 2)
    svg += svgLine({kLeft, heightOf(v, reach)}, {kWidth - kRight, heightOf(v, reach)}, "grid") +
           svgText({kLeft - 6, heightOf(v, reach) + 4}, "end", "", niceText(v, reach / 2)) + "\n";
  return svg + svgText({4, 15}, "start", "", "residual in standard deviations") + "\n";
}

std::string mark(const std::string& id, const LandmarkScore& landmark, double x, double reach, bool named)
{
  const double mean = *landmark.residual_mean, spread = landmark.residual_std.value_or(0);
  const std::string doubt = landmarkWarning(landmark);
  const std::string css_class = doubt.empty() ? "residual" : "residual doubtful";
  std::string svg = svgLine({x, heightOf(mean - spread, reach)}, {x, heightOf(mean + spread, reach)}, css_class);
  svg += "<circle class=\"" + css_class + "\" r=\"4\" cx=\"" + svgNumber(x) + "\" cy=\"" +
         svgNumber(heightOf(mean, reach)) + "\">" +
         element("title", "", escapeHtml("landmark " + id + (doubt.empty() ? "" : ": " + doubt))) + "</circle>";
  if (named) svg += svgText({x, kHeight - kBottom + 18}, "middle", "", id);
  return svg + "\n";
}
}  // namespace

std::string residualChart(const RunScore& score)
{
  std::vector<std::string> ids;
  double reach = 2;
  for (const std::string& id : landmarkOrder(score))
  {
    const LandmarkScore& landmark = score.landmarks.at(id);
    if (!landmark.residual_mean) continue;
    ids.push_back(id);
    reach = std::max(reach, std::abs(*landmark.residual_mean) + landmark.residual_std.value_or(0));
  }
  if (ids.empty() || ids.size() > kMaxLandmarks) return {};
  reach = std::min(2 * std::ceil(reach / 2), 10.0);
  std::string svg = "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + svgNumber(kWidth) + " " + svgNumber(kHeight) +
                    "\"><title>Residuals of every landmark</title>\n" + frame(reach);
  const double step = (kWidth - kLeft - kRight) / static_cast<double>(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
    svg += mark(ids[i], score.landmarks.at(ids[i]), kLeft + (static_cast<double>(i) + 0.5) * step, reach,
                ids.size() <= kMaxNames);
  return svg + "</svg>\n";
}
}  // namespace mrpt_ext
