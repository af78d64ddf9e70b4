#include "mrpt_ext/vision/stereo/upright_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr int kWhiteStep = 16;               ///< [px] between pixels that define white
constexpr double kSameFeature = 1.5;         ///< [px] disparities of one feature agree
constexpr double kSameColumn = 1;            ///< [px] likewise columns
constexpr int kLookRows = 8;                 ///< rows of a first look
constexpr int kLeastLookRows = 3;            ///< of them that must agree
constexpr double kOutlier = 3;               ///< in robust standard deviations
constexpr double kLeastScatter = 0.2;        ///< [px] least robust standard deviation of a row's column
constexpr double kMostSlope = 0.08;          ///< columns per row of an upright edge: a camera may roll by some degrees
constexpr double kUsualCorrelation = 0.4;    ///< of neighbouring rows
constexpr double kCorrelationRows = 10;      ///< rows that what is usual counts as
constexpr double kLargestCorrelation = 0.8;  ///< beyond it the rows tell nothing about it
constexpr double kAgreeingShare = 0.5;       ///< of the rows of the left image

/// The value that most of all agree with, and how many do.
std::pair<double, int> commonest(const std::vector<double>& all, double tolerance)
{
  std::pair<double, int> best{0, 0};
  for (const double value : all)
  {
    const auto count =
        std::count_if(all.begin(), all.end(), [&](double other) { return std::abs(other - value) <= tolerance; });
    if (count > best.second) best = {value, static_cast<int>(count)};
  }
  return best;
}

double nearest(const std::vector<double>& values, double to)
{
  return *std::min_element(values.begin(), values.end(),
                           [&](double a, double b) { return std::abs(a - to) < std::abs(b - to); });
}

void eraseNear(std::vector<double>& values, double to, double tolerance)
{
  std::erase_if(values, [&](double value) { return std::abs(value - to) <= tolerance; });
}

struct MeanColumn
{
  double mean = 0, std = 0;  ///< [px] of the mean
};

/// Of neighbouring rows: what moves one (JPEG, coarse colour, the raster that a leaning edge crosses) lasts for some.
template <typename Row>
double correlationOf(const std::vector<Row>& rows, double Row::*member, double mean)
{
  double squares = 0, products = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    squares += square(rows[i].*member - mean);
    if (i > 0) products += (rows[i].*member - mean) * (rows[i - 1].*member - mean);
  }
  const double usual = kCorrelationRows * squares / static_cast<double>(rows.size());
  if (!(squares > 0)) return 0;
  return std::clamp((products + kUsualCorrelation * usual) / (squares + usual), 0.0, kLargestCorrelation);
}

/// The standard deviation of the mean is that of independent rows, wider by what their correlation makes of it.
template <typename Row>
MeanColumn meanOf(const std::vector<Row>& rows, double Row::*member)
{
  const double n = static_cast<double>(rows.size());
  MeanColumn result;
  for (const Row& r : rows) result.mean += r.*member / n;
  for (const Row& r : rows) result.std += square(r.*member - result.mean);
  const double correlation = correlationOf(rows, member, result.mean);
  result.std = std::sqrt(result.std / (n * (n - 1)) * (1 + correlation) / (1 - correlation));
  return result;
}

/// Whether the columns, which were moved along an upright edge to one row, stay where they are from row to row.
template <typename Row>
bool isUpright(const std::vector<Row>& rows, double Row::*column)
{
  const double n = static_cast<double>(rows.size());
  if (rows.size() < 3) return true;
  double mean_row = 0, mean_column = 0, rr = 0, rc = 0, cc = 0;
  for (const Row& r : rows) mean_row += r.row / n, mean_column += r.*column / n;
  for (const Row& r : rows)
  {
    const double down = r.row - mean_row, aside = r.*column - mean_column;
    rr += down * down, rc += down * aside, cc += aside * aside;
  }
  const double slope = rc / rr, variance = std::max(0.0, cc - slope * rc) / (n - 2) / rr;
  return std::abs(slope) <= kMostSlope + kOutlier * std::sqrt(variance);
}

/// What colour and brightness tell of one column. Where they differ by more than their scatter, colour errs by it. The
/// result is no surer than they are, since what the scatter does not show may move both alike.
MeanColumn jointColumn(const MeanColumn& colour, const MeanColumn& brightness, double floor)
{
  const double colour_variance = square(colour.std) + std::max(0.0, square(colour.mean - brightness.mean) -
                                                                        square(colour.std) - square(brightness.std));
  const double of_colour = colour_variance + square(floor),
               of_both = of_colour + square(brightness.std) + square(floor);
  const double share = of_both > 0 ? of_colour / of_both : 0.5;  // of brightness
  return {colour.mean + share * (brightness.mean - colour.mean),
          (1 - share) * std::sqrt(colour_variance) + share * brightness.std};
}

/// Removes rows whose value is an outlier against the median and its scatter.
template <typename Row>
void removeOutliers(std::vector<Row>& rows, double Row::*member)
{
  if (rows.empty()) return;
  std::vector<double> values;
  for (const Row& r : rows) values.push_back(r.*member);
  const double middle = upperMedian(values);
  for (double& v : values) v = std::abs(v - middle);
  const double limit = kOutlier * std::max(kLeastScatter, upperMedian(values) / kNormalMedianDeviation);
  std::erase_if(rows, [&](const Row& r) { return std::abs(r.*member - middle) > limit; });
}
}  // namespace

/// The step in one row of the left image, moved along the upright edge to a common row, and where it may be in the
/// right.
struct UprightEdges::RowStep
{
  int row = 0;
  double left = 0;
  std::vector<double> disparities;
  double disparity = 0;
};

struct UprightEdges::InBrightness
{
  std::vector<RowStep> rows;
  PaintInShade left, right;
};

UprightEdges::UprightEdges(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera,
                           const EdgeSearch& search)
    : left_(left), right_(right), camera_(camera), search_(search), least_white_(leastWhite(left, kWhiteStep))
{
}

double UprightEdges::atMiddleRow(double column, int row, const EdgeWindow& window) const
{
  return column - camera_.uprightSlope(cv::Point2d(column, window.middle())) * (row - window.middle());
}

std::vector<UprightEdges::RowStep> UprightEdges::stepsInLeft(const EdgeWindow& window, const ColourStep& step) const
{
  const int column = static_cast<int>(std::lround(window.column));
  std::vector<RowStep> rows;
  for (int row = window.first_row; row <= window.last_row; ++row)
  {
    auto steps = stepsInRow(left_, row, column - window.reach, column + window.reach, step, least_white_);
    if (steps.empty()) continue;
    rows.push_back({row, atMiddleRow(nearest(steps, window.column), row, window), {}, 0});
  }
  removeOutliers(rows, &RowStep::left);
  return rows;
}

void UprightEdges::searchRight(std::vector<RowStep>& rows, const EdgeWindow& window, const ColourStep& step) const
{
  for (RowStep& r : rows)
  {
    const int first = static_cast<int>(std::floor(r.left - search_.most_disparity)) - 2;
    const int last = static_cast<int>(std::ceil(r.left - search_.least_disparity)) + 2;
    for (const double column : stepsInRow(right_, r.row, first, last, step, least_white_))
    {
      const double disparity = r.left - atMiddleRow(column, r.row, window);
      if (disparity > search_.least_disparity && disparity < search_.most_disparity) r.disparities.push_back(disparity);
    }
  }
}

std::vector<double> UprightEdges::columnsIn(const EdgeWindow& window, const ColourStep& step) const
{
  const int column = static_cast<int>(std::lround(window.column));
  const int stride = std::max(1, (window.last_row - window.first_row) / kLookRows);
  std::vector<double> all, columns;
  for (int row = window.first_row; row <= window.last_row; row += stride)
    for (const double found : stepsInRow(left_, row, column - window.reach, column + window.reach, step, least_white_))
      all.push_back(atMiddleRow(found, row, window));
  for (auto best = commonest(all, kSameColumn); best.second >= kLeastLookRows; best = commonest(all, kSameColumn))
  {
    columns.push_back(best.first);
    eraseNear(all, best.first, 2 * kSameColumn);
  }
  return columns;
}

std::vector<UprightEdge> UprightEdges::in(const EdgeWindow& window, const ColourStep& step) const
{
  std::vector<RowStep> rows = stepsInLeft(window, step);
  searchRight(rows, window, step);
  std::vector<UprightEdge> edges;
  while (true)
  {
    std::vector<double> all;
    for (const RowStep& r : rows) all.insert(all.end(), r.disparities.begin(), r.disparities.end());
    const auto [disparity, most] = commonest(all, kSameFeature);
    if (most < search_.min_rows || most < kAgreeingShare * static_cast<double>(rows.size())) return edges;
    std::vector<RowStep> agreeing;
    for (RowStep& r : rows)
    {
      if (r.disparities.empty()) continue;
      r.disparity = nearest(r.disparities, disparity);
      if (std::abs(r.disparity - disparity) <= kSameFeature) agreeing.push_back(r);
      eraseNear(r.disparities, disparity, kSameFeature);
    }
    removeOutliers(agreeing, &RowStep::disparity);
    if (static_cast<int>(agreeing.size()) < std::max(2, search_.min_rows)) continue;
    if (isUpright(agreeing, &RowStep::left)) edges.push_back(measured(agreeing, window, step));
  }
}

/// The same rows of an edge, located by brightness.
UprightEdges::InBrightness UprightEdges::inBrightness(const std::vector<RowStep>& rows, const EdgeWindow& window,
                                                      int side) const
{
  const double middle = window.middle(), column = rows.front().left;
  const double slope_left = camera_.uprightSlope({column, middle}),
               slope_right = camera_.uprightSlope({column - rows.front().disparity, middle});
  InBrightness result;
  for (const RowStep& r : rows)
  {
    const double lean_left = slope_left * (r.row - middle), lean_right = slope_right * (r.row - middle);
    const auto left = brightnessStepAt(left_, r.row, r.left + lean_left, side),
               right = brightnessStepAt(right_, r.row, r.left - r.disparity + lean_right, side);
    if (!left || !right) continue;
    const double u = left->column - lean_left;
    result.rows.push_back({r.row, u, {}, u - right->column + lean_right});
    result.left += left->shade, result.right += right->shade;
  }
  removeOutliers(result.rows, &RowStep::left), removeOutliers(result.rows, &RowStep::disparity);
  return result;
}

UprightEdge UprightEdges::measured(const std::vector<RowStep>& rows, const EdgeWindow& window,
                                   const ColourStep& step) const
{
  auto u = meanOf(rows, &RowStep::left), d = meanOf(rows, &RowStep::disparity);
  const auto bright = step.colour ? inBrightness(rows, window, step.side) : InBrightness{};
  if (2 * bright.rows.size() > rows.size() && bright.rows.size() > 1)
  {
    auto bright_u = meanOf(bright.rows, &RowStep::left), bright_d = meanOf(bright.rows, &RowStep::disparity);
    const double left = bright.left.shift(), right = bright.right.shift();
    bright_u.std = std::hypot(bright_u.std, left), bright_d.std = std::hypot(bright_d.std, left - right);
    u = jointColumn(u, bright_u, search_.std_column);
    d = jointColumn(d, bright_d, search_.std_disparity);
  }
  UprightEdge edge{{u.mean, static_cast<double>(window.middle())},
                   d.mean,
                   std::hypot(search_.std_column, u.std),
                   std::hypot(search_.std_disparity, d.std),
                   {}};
  for (const RowStep& r : rows) edge.rows.push_back(r.row);
  return edge;
}
}  // namespace mrpt_ext
