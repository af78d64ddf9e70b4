#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/report/svg_shapes.h"

namespace mrpt_ext
{
/// A figure over time.
struct ChartSeries
{
  std::string css_class;
  bool dots = false;             ///< single estimates instead of a curve
  std::vector<Vector2d> points;  ///< (seconds since the start of the log, value)
};

/// A vertical line at a moment, or a shaded time span.
struct ChartMark
{
  double from = 0, to = 0;  ///< [s] since the start of the log; equal for a moment
  std::string css_class;
  std::string label;  ///< may be empty; always shown as a tool tip
};

struct Chart
{
  std::string description;  ///< for readers that do not see the drawing
  std::string unit;         ///< at the vertical axis
  double duration = 0;      ///< [s]
  std::vector<ChartSeries> series;
  std::vector<ChartMark> marks;
  std::optional<double> level;   ///< horizontal line, e.g. a limit
  std::optional<Vector2d> band;  ///< shaded between two values
  std::optional<double> top;     ///< fixed upper end of a linear axis from 0; else chosen from the data
  double break_after = 0;        ///< curves are interrupted over longer gaps [s]; 0: never
};

/// Static drawing with a time axis. The vertical axis is logarithmic when the values span more than a factor 30.
[[nodiscard]] std::string svgChart(const Chart& chart);
}  // namespace mrpt_ext
