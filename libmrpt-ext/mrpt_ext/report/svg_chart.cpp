#include "mrpt_ext/report/svg_chart.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/report/html_text.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWidth = 720, kHeight = 320;
constexpr double kLeft = 62, kRight = 12, kTop = 34, kBottom = 50;
constexpr std::size_t kMaxPoints = 1200;  // per series: more than the drawing can resolve
constexpr double kLogSpan = 30;           // from this ratio of values on the axis is logarithmic
constexpr double kLogDecades = 5;         // at most
constexpr double kDrawnFrom = 0.02;       // quantile at the lower end; smaller values are drawn on it

/// Maps values to drawing units.
struct Axes
{
  double duration = 1;
  double low = 0, high = 1;
  bool logarithmic = false;

  [[nodiscard]] double x(double t) const { return kLeft + (kWidth - kLeft - kRight) * t / duration; }
  [[nodiscard]] double y(double value) const
  {
    const double share =
        logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low) : (value - low) / (high - low);
    return kHeight - kBottom - (kHeight - kTop - kBottom) * std::clamp(share, 0.0, 1.0);
  }
};

Axes axesFor(const Chart& chart)
{
  Axes axes;
  axes.duration = chart.duration > 0 ? chart.duration : 1;
  if (chart.top)
  {
    axes.high = *chart.top;
    return axes;
  }
  std::vector<double> values;  // a zero has no place on a logarithmic axis
  for (const ChartSeries& series : chart.series)
    for (const Vector2d& p : series.points)
      if (p.y() > 0) values.push_back(p.y());
  if (chart.band) values.insert(values.end(), {chart.band->x(), chart.band->y()});
  if (values.empty()) return axes;
  const double largest = *quantile(values, 1.0), small = *quantile(values, kDrawnFrom);
  axes.logarithmic = largest > kLogSpan * small;
  if (axes.logarithmic)
  {
    axes.high = std::pow(10, std::ceil(std::log10(largest)));
    axes.low = std::pow(10, std::max(std::floor(std::log10(small)), std::log10(axes.high) - kLogDecades));
    return axes;
  }
  const double step = niceStep(largest / 3);
  axes.high = step * std::ceil(largest / step);
  return axes;
}

std::string horizontalGrid(const Axes& axes, double value, const std::string& label)
{
  const double y = axes.y(value);
  return svgLine({kLeft, y}, {kWidth - kRight, y}, "grid") + svgText({kLeft - 6, y + 4}, "end", "", label) + "\n";
}

std::string valueAxis(const Axes& axes)
{
  std::string svg;
  if (axes.logarithmic)
  {
    for (double v = axes.low; v < axes.high * 1.5; v *= 10)
      svg += horizontalGrid(axes, v, niceText(v, std::min(v, 1.0)));
    return svg;
  }
  const double step = niceStep((axes.high - axes.low) / 3);
  for (int i = 0; axes.low + i * step < axes.high + 0.01 * step; ++i)
    svg += horizontalGrid(axes, axes.low + i * step, niceText(axes.low + i * step, step));
  return svg;
}

std::string timeAxis(const Axes& axes)
{
  std::string svg;
  const double step = niceStep(axes.duration / 4), bottom = kHeight - kBottom;
  for (int i = 0; i * step < axes.duration * (1 + 1e-9); ++i)
  {
    const double x = axes.x(i * step);
    const std::string anchor = x > kWidth - kRight - 20 ? "end" : "middle";  // the last one must not be cut off
    svg +=
        svgLine({x, bottom}, {x, bottom + 4}, "axis") + svgText({x, bottom + 19}, anchor, "", niceText(i * step, step));
  }
  return svg + svgLine({kLeft, bottom}, {kWidth - kRight, bottom}, "axis") +
         svgText({kWidth - kRight, kHeight - 4}, "end", "", "s since the start of the log") + "\n";
}

std::string markShape(const ChartMark& mark, const Axes& axes)
{
  const double from = axes.x(mark.from), to = axes.x(mark.to);
  const std::string tip = element("title", "", escapeHtml(mark.label));
  if (mark.to > mark.from)
    return "<rect class=\"" + mark.css_class + "\" x=\"" + svgNumber(from) + "\" y=\"" + svgNumber(kTop) +
           "\" width=\"" + svgNumber(std::max(1.0, to - from)) + "\" height=\"" + svgNumber(kHeight - kTop - kBottom) +
           "\">" + tip + "</rect>\n";
  return "<path class=\"" + mark.css_class + "\" d=\"M" + svgNumber(from) + " " + svgNumber(kTop) + "V" +
         svgNumber(kHeight - kBottom) + "\">" + tip + "</path>\n";
}

std::string bandShape(const Vector2d& band, const Axes& axes)
{
  const double bottom = axes.y(band.x()), top = axes.y(band.y());
  return "<rect class=\"band\" x=\"" + svgNumber(kLeft) + "\" y=\"" + svgNumber(top) + "\" width=\"" +
         svgNumber(kWidth - kLeft - kRight) + "\" height=\"" + svgNumber(bottom - top) + "\"/>\n";
}

std::string curve(const ChartSeries& series, const Axes& axes, double break_after)
{
  const auto draw = [&](const SvgPoints& part)
  { return part.size() == 1 ? svgDots(part, series.css_class) : svgPolyline(part, series.css_class); };
  std::string svg;
  SvgPoints part;
  const std::vector<Vector2d> points = thinnedCurve(series.points, kMaxPoints);
  // Thinning widens the distance of neighbours, which must not look like gaps.
  const double widened = break_after * std::max(1.0, 2.0 * static_cast<double>(series.points.size()) / kMaxPoints);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (i > 0 && break_after > 0 && points[i].x() - points[i - 1].x() > widened)
    {
      svg += draw(part);
      part.clear();
    }
    part.emplace_back(axes.x(points[i].x()), axes.y(points[i].y()));
  }
  return svg + draw(part);
}

std::string dots(const ChartSeries& series, const Axes& axes)
{
  SvgPoints drawn;
  for (const Vector2d& p : thinnedCurve(series.points, kMaxPoints)) drawn.emplace_back(axes.x(p.x()), axes.y(p.y()));
  return svgDots(drawn, series.css_class);
}
}  // namespace

std::string svgChart(const Chart& chart)
{
  const Axes axes = axesFor(chart);
  std::string svg = "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + svgNumber(kWidth) + " " + svgNumber(kHeight) +
                    "\">" + element("title", "", escapeHtml(chart.description)) + "\n";
  for (const ChartMark& mark : chart.marks)
    if (mark.to > mark.from) svg += markShape(mark, axes);
  if (chart.band) svg += bandShape(*chart.band, axes);
  svg += valueAxis(axes) + timeAxis(axes);
  svg += svgText({4, 15}, "start", "", chart.unit + (axes.logarithmic ? ", logarithmic" : ""));
  for (const ChartSeries& series : chart.series)  // dots lie below the curves
    if (series.dots) svg += dots(series, axes);
  for (const ChartSeries& series : chart.series)
    if (!series.dots) svg += curve(series, axes, chart.break_after);
  if (chart.level && *chart.level >= axes.low && *chart.level <= axes.high)
    svg += svgLine({kLeft, axes.y(*chart.level)}, {kWidth - kRight, axes.y(*chart.level)}, "level");
  for (const ChartMark& mark : chart.marks)
    if (!(mark.to > mark.from)) svg += markShape(mark, axes);
  return svg + "</svg>\n";
}
}  // namespace mrpt_ext
