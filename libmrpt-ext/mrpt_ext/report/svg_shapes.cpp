#include "mrpt_ext/report/svg_shapes.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/report/html_text.h"

namespace mrpt_ext
{
namespace
{
std::string pair(const Vector2d& p) { return svgNumber(p.x()) + " " + svgNumber(p.y()); }
}  // namespace

std::string svgNumber(double value)
{
  std::string text = fixedText(value, 1);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string svgLine(const Vector2d& from, const Vector2d& to, const std::string& css_class)
{
  return "<path class=\"" + css_class + "\" d=\"M" + pair(from) + "L" + pair(to) + "\"/>";
}

std::string svgText(const Vector2d& at, const std::string& anchor, const std::string& css_class,
                    const std::string& text)
{
  return "<text x=\"" + svgNumber(at.x()) + "\" y=\"" + svgNumber(at.y()) + "\" text-anchor=\"" + anchor +
         "\" class=\"" + css_class + "\">" + escapeHtml(text) + "</text>";
}

std::string svgPolyline(const SvgPoints& points, const std::string& css_class)
{
  if (points.size() < 2) return {};
  std::string path = "<path class=\"line " + css_class + "\" d=\"M" + pair(points.front()) + "L";
  for (std::size_t i = 1; i < points.size(); ++i) path += (i > 1 ? " " : "") + pair(points[i]);
  return path + "\"/>\n";
}

std::string svgDots(const SvgPoints& points, const std::string& css_class)
{
  if (points.empty()) return {};
  std::string path = "<path class=\"dots " + css_class + "\" d=\"";
  for (const Vector2d& p : points) path += "M" + pair(p) + "h0";
  return path + "\"/>\n";
}

SvgPoints thinnedByDistance(const SvgPoints& points, double distance)
{
  SvgPoints kept;
  for (const Vector2d& p : points)
    if (kept.empty() || (p - kept.back()).norm() >= distance) kept.push_back(p);
  if (!points.empty() && kept.back() != points.back()) kept.push_back(points.back());
  return kept;
}

SvgPoints thinnedPath(const SvgPoints& points, double distance, std::size_t count)
{
  constexpr double kWholeDrawing = 1000;
  SvgPoints kept = thinnedByDistance(points, distance);
  while (kept.size() > std::max<std::size_t>(count, 2) && distance < kWholeDrawing)
    kept = thinnedByDistance(points, distance *= 2);
  return kept;
}

double niceStep(double size)
{
  const double decade = std::pow(10.0, std::floor(std::log10(size)));
  const double share = size / decade * (1 + 1e-9);
  return decade * (share >= 5 ? 5 : share >= 2 ? 2 : 1);
}

std::string niceText(double value, double step)
{
  return fixedText(value, std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9))));
}
}  // namespace mrpt_ext
