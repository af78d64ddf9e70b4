#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Elements of a drawing; coordinates in drawing units, y downwards, one decimal. Colours come from the CSS classes.
using SvgPoints = std::vector<Vector2d>;

[[nodiscard]] std::string svgNumber(double value);
[[nodiscard]] std::string svgLine(const Vector2d& from, const Vector2d& to, const std::string& css_class);
[[nodiscard]] std::string svgText(const Vector2d& at, const std::string& anchor, const std::string& css_class,
                                  const std::string& text);
/// One line through the points; fewer than two points draw nothing.
[[nodiscard]] std::string svgPolyline(const SvgPoints& points, const std::string& css_class);
/// Many dots as one path of zero-length strokes (the CSS gives them round ends), which keeps the file small.
[[nodiscard]] std::string svgDots(const SvgPoints& points, const std::string& css_class);

/// Without points closer than `distance` to the last one kept; the last point always stays.
[[nodiscard]] SvgPoints thinnedByDistance(const SvgPoints& points, double distance);
/// Thinned with the smallest of the distances `distance`, 2 `distance`, 4 `distance` ... that leaves at most `count`.
[[nodiscard]] SvgPoints thinnedPath(const SvgPoints& points, double distance, std::size_t count);

/// Steps of 1, 2 or 5 times a power of ten: the largest that is not above `size` > 0.
[[nodiscard]] double niceStep(double size);
/// Text of a multiple of such a step, with the decimals it needs.
[[nodiscard]] std::string niceText(double value, double step);
}  // namespace mrpt_ext
