#include "mrpt_ext/vision/goal_corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr int kWindow = 10;             ///< [px] around the candidate's column
constexpr int kWhiteStep = 16;          ///< [px] between pixels that define white
constexpr int kInside = 4;              ///< [px] from the step to where the coloured side's height is measured
constexpr double kSameFeature = 1.5;    ///< [px] disparities of one feature agree
constexpr double kOutlier = 3;          ///< in robust standard deviations
constexpr double kLeastScatter = 0.2;   ///< [px] least robust standard deviation of a row's column
constexpr double kAgreeingShare = 0.5;  ///< of the rows of the left image
constexpr float kAsWhite = 0.6F;        ///< of the white beside the step is still it, share of each channel
constexpr int kFootReach = 10;          ///< [px] to either side that the foot is followed
constexpr int kFootPoints = 5;          ///< of a line
constexpr double kFootStep = 0.6;       ///< [px] by more a wall's foot is lower where it covers the goal
constexpr double kHollow = 140;         ///< [deg] a quarter of a turn, as badly as it can be measured
constexpr double kEndOfRows = 1.5;      ///< [px] a height in the image is known to

/// The step in one row of the left image, moved along the upright edge to a common row, and where it may be in the
/// right.
struct RowStep
{
  int row = 0;
  double left = 0;
  std::vector<double> disparities;
  double disparity = 0;
};

/// Removes rows whose value is an outlier against the median and its scatter.
template <typename Value>
void removeOutliers(std::vector<RowStep>& rows, const Value& value)
{
  if (rows.empty()) return;
  std::vector<double> values;
  for (const RowStep& r : rows) values.push_back(value(r));
  const double middle = upperMedian(values);
  for (double& v : values) v = std::abs(v - middle);
  const double limit = kOutlier * std::max(kLeastScatter, upperMedian(values) / kNormalMedianDeviation);
  rows.erase(
      std::remove_if(rows.begin(), rows.end(), [&](const RowStep& r) { return std::abs(value(r) - middle) > limit; }),
      rows.end());
}

double meanOf(const std::vector<RowStep>& rows, double RowStep::*member)
{
  double sum = 0;
  for (const RowStep& r : rows) sum += r.*member;
  return sum / static_cast<double>(rows.size());
}

double stdOfMean(const std::vector<RowStep>& rows, double RowStep::*member, double mean)
{
  double sum = 0;
  for (const RowStep& r : rows) sum += square(r.*member - mean);
  const double n = static_cast<double>(rows.size());
  return std::sqrt(sum / (n * (n - 1)));
}

/// The line of a wall's foot in the image, by least squares: rows over columns away from a corner.
class FootLine
{
 public:
  void add(double column, double row)
  {
    ++count_, columns_ += column, rows_ += row, squares_ += column * column, products_ += column * row;
  }
  [[nodiscard]] int size() const { return count_; }
  [[nodiscard]] double slope() const
  {
    return (count_ * products_ - columns_ * rows_) / (count_ * squares_ - columns_ * columns_);
  }
  [[nodiscard]] double atZero() const { return (rows_ - slope() * columns_) / count_; }

 private:
  int count_ = 0;
  double columns_ = 0, rows_ = 0, squares_ = 0, products_ = 0;
};

class CornerFinder
{
 public:
  CornerFinder(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera,
               const GoalCornerSettings& settings)
      : left_(left), right_(right), camera_(camera), settings_(settings), least_white_(leastWhite(left, kWhiteStep))
  {
  }

  [[nodiscard]] std::optional<GoalCorner> at(const CornerCandidate& candidate) const
  {
    const GoalColour& colour = settings_.colours[static_cast<std::size_t>(candidate.colour)];
    std::vector<RowStep> rows = stepsInLeft(candidate, colour);
    removeOutliers(rows, [](const RowStep& r) { return r.left; });
    searchRight(rows, candidate, colour);
    // A robot and a goal beside it may both agree with some disparity: the one most rows agree with comes first.
    while (static_cast<int>(rows.size()) >= settings_.min_rows)
    {
      const auto disparity = commonDisparity(rows);
      if (!disparity) return std::nullopt;
      if (const auto corner = measure(rows, *disparity, candidate, colour)) return corner;
      for (RowStep& r : rows)
        r.disparities.erase(std::remove_if(r.disparities.begin(), r.disparities.end(),
                                           [&](double d) { return std::abs(d - *disparity) <= kSameFeature; }),
                            r.disparities.end());
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::vector<RowStep> stepsInLeft(const CornerCandidate& candidate, const GoalColour& colour) const
  {
    const int middle = (candidate.first_row + candidate.last_row) / 2, margin = settings_.scan_step;
    const int column = static_cast<int>(std::lround(candidate.column));
    const double slope = camera_.uprightSlope(cv::Point2d(candidate.column, middle));
    std::vector<RowStep> rows;
    for (int row = candidate.first_row - margin; row <= candidate.last_row + margin; ++row)
    {
      const auto steps =
          colourStepsInRow(left_, row, column - kWindow, column + kWindow, colour, candidate.side, least_white_);
      if (steps.empty()) continue;
      const auto nearest = std::min_element(
          steps.begin(), steps.end(),
          [&](double a, double b) { return std::abs(a - candidate.column) < std::abs(b - candidate.column); });
      rows.push_back({row, *nearest - slope * (row - middle), {}, 0});
    }
    return rows;
  }

  void searchRight(std::vector<RowStep>& rows, const CornerCandidate& candidate, const GoalColour& colour) const
  {
    const double nearest = camera_.disparityAt(settings_.min_range),
                 farthest = camera_.disparityAt(settings_.max_range);
    const int middle = (candidate.first_row + candidate.last_row) / 2;
    for (RowStep& r : rows)
    {
      const int first = static_cast<int>(std::floor(r.left - nearest)) - 2;
      const int last = static_cast<int>(std::ceil(r.left - farthest)) + 2;
      for (const double column : colourStepsInRow(right_, r.row, first, last, colour, candidate.side, least_white_))
      {
        const double slope = camera_.uprightSlope(cv::Point2d(column, middle));
        const double disparity = r.left - (column - slope * (r.row - middle));
        if (disparity > farthest && disparity < nearest) r.disparities.push_back(disparity);
      }
    }
  }

  /// The disparity that most rows agree with.
  [[nodiscard]] std::optional<double> commonDisparity(const std::vector<RowStep>& rows) const
  {
    std::vector<double> all;
    for (const RowStep& r : rows) all.insert(all.end(), r.disparities.begin(), r.disparities.end());
    std::ptrdiff_t most = 0;
    double best = 0;
    for (const double d : all)
    {
      const auto close = [&](double other) { return std::abs(other - d) <= kSameFeature; };
      const auto count = std::count_if(all.begin(), all.end(), close);
      if (count > most) most = count, best = d;
    }
    if (most < settings_.min_rows || static_cast<double>(most) < kAgreeingShare * static_cast<double>(rows.size()))
      return std::nullopt;
    return best;
  }

  [[nodiscard]] std::optional<GoalCorner> measure(std::vector<RowStep> rows, double disparity,
                                                  const CornerCandidate& candidate, const GoalColour& colour) const
  {
    std::vector<RowStep> agreeing;
    for (RowStep& r : rows)
    {
      if (r.disparities.empty()) continue;
      r.disparity =
          *std::min_element(r.disparities.begin(), r.disparities.end(),
                            [&](double a, double b) { return std::abs(a - disparity) < std::abs(b - disparity); });
      if (std::abs(r.disparity - disparity) <= kSameFeature) agreeing.push_back(r);
    }
    removeOutliers(agreeing, [](const RowStep& r) { return r.disparity; });
    if (static_cast<int>(agreeing.size()) < std::max(2, settings_.min_rows)) return std::nullopt;

    const double u = meanOf(agreeing, &RowStep::left), d = meanOf(agreeing, &RowStep::disparity);
    const double std_u = std::hypot(settings_.std_column, stdOfMean(agreeing, &RowStep::left, u));
    const double std_d = std::hypot(settings_.std_disparity, stdOfMean(agreeing, &RowStep::disparity, d));
    const cv::Point2d middle(u, (candidate.first_row + candidate.last_row) / 2);  // the row columns were moved to
    const auto measured = measureStereo(camera_, middle, d, std_u, std_d);
    if (!measured) return std::nullopt;

    GoalCorner corner{candidate.colour, candidate.side, u, u - d, 0, 0, 0, *measured};
    findHeight(corner, agreeing, middle, colour);
    if (!looksLikeGoal(corner) || isHollow(corner, middle, colour)) return std::nullopt;
    const double to_foot = corner.white_bottom - middle.y;
    corner.u_left += to_foot * camera_.uprightSlope(middle);
    corner.u_right += to_foot * camera_.uprightSlope({u - d, middle.y});
    return corner;
  }

  /// How far the coloured side reaches up and down from the rows that were measured, and how far down the white one.
  void findHeight(GoalCorner& corner, const std::vector<RowStep>& rows, const cv::Point2d& middle,
                  const GoalColour& colour) const
  {
    const auto beside = [&](int row, int offset)
    {
      const double u = middle.x + camera_.uprightSlope(middle) * (row - middle.y) + corner.side * offset;
      return meanAround(left_, row, std::clamp(static_cast<int>(std::lround(u)), 0, left_.cols - 1));
    };
    cv::Vec3f white(0, 0, 0);
    for (const RowStep& r : rows) white += beside(r.row, -kInside) * (1.F / static_cast<float>(rows.size()));
    const auto inImage = [this](int row) { return row >= 0 && row < left_.rows; };
    const auto isColoured = [&](int row) { return inImage(row) && colour.matches(white, beside(row, kInside)); };
    const auto isAsWhite = [&](int row) { return inImage(row) && isWhite(beside(row, -kInside), kAsWhite * white); };
    const int start = rows[rows.size() / 2].row;
    corner.row_top = lastRow(start, -1, isColoured) - 0.5;
    corner.row_bottom = lastRow(start, 1, isColoured) + 0.5;
    corner.white_bottom = lastRow(start, 1, isAsWhite) + 0.5;
  }

  /// The pixels beside the upright edge through a point.
  [[nodiscard]] std::optional<cv::Vec3f> beside(const cv::Point2d& edge, int row, int offset) const
  {
    const double u = edge.x + camera_.uprightSlope(edge) * (row - edge.y) + offset;
    const int column = static_cast<int>(std::lround(u));
    if (row < 0 || row >= left_.rows || column < 0 || column >= left_.cols) return std::nullopt;
    return meanAround(left_, row, column);
  }

  /// The row in which what `belongs` to a wall ends, to a fraction: half way to the level of what is below.
  template <typename Belongs>
  [[nodiscard]] std::optional<double> footAt(const cv::Point2d& edge, int offset, const Belongs& belongs) const
  {
    const auto level = [&](int row)
    {
      const auto pixel = beside(edge, row, offset);
      return pixel ? std::optional(std::max({(*pixel)[0], (*pixel)[1], (*pixel)[2]})) : std::nullopt;
    };
    const int last = lastRow(static_cast<int>(std::lround(edge.y)), 1,
                             [&](int row)
                             {
                               const auto pixel = beside(edge, row, offset);
                               return pixel && belongs(*pixel);
                             });
    const auto wall = level(last - 2), floor = level(last + 3);
    if (!wall || !floor) return std::nullopt;
    const float half = 0.5F * (*wall + *floor);
    for (int row = last - 1; row <= last + 2; ++row)
      if (const float above = *level(row), below = *level(row + 1); above >= half && below < half)
        return row + static_cast<double>((above - half) / (above - below));
    return std::nullopt;
  }

  /// From the foot of an edge along a wall's foot, on the floor [m]; zero where the floor is not seen.
  [[nodiscard]] Eigen::Vector2d footDirection(const FootLine& line, double column, int side) const
  {
    const auto begin = camera_.floorAt({column, line.atZero()});
    const auto end = camera_.floorAt({column + side * kFootReach, line.atZero() + line.slope() * kFootReach});
    return begin && end ? Eigen::Vector2d(*end - *begin) : Eigen::Vector2d::Zero();
  }

  /// Whether it is the corner between a goal's white side and its coloured back: there the floor fills a quarter of a
  /// turn between the walls' feet. At a corner of the goal it fills three, or the wall covers the goal's foot, which is
  /// then higher in the image than the wall's.
  [[nodiscard]] bool isHollow(const GoalCorner& corner, const cv::Point2d& edge, const GoalColour& colour) const
  {
    const auto white = beside(edge, static_cast<int>(std::lround(edge.y)), -corner.side * kInside);
    if (!white) return false;
    FootLine of_colour, of_white;
    for (int offset = kInside - 1; offset <= kFootReach; ++offset)
    {
      if (const auto row =
              footAt(edge, corner.side * offset, [&](const cv::Vec3f& pixel) { return colour.matches(*white, pixel); }))
        of_colour.add(offset, *row);
      if (const auto row = footAt(edge, -corner.side * offset,
                                  [&](const cv::Vec3f& pixel) { return isWhite(pixel, kAsWhite * *white); }))
        of_white.add(offset, *row);
    }
    if (of_colour.size() < kFootPoints || of_white.size() < kFootPoints) return false;
    if (of_white.atZero() - of_colour.atZero() > kFootStep) return false;
    Eigen::Vector2d left = footDirection(of_white, edge.x, -corner.side),
                    right = footDirection(of_colour, edge.x, corner.side);
    if (corner.side < 0) std::swap(left, right);
    const double angle = std::atan2(left.x() * right.y() - left.y() * right.x(), left.dot(right));
    return angle > 0 && angle < degToRad(kHollow);
  }

  /// The last row up or down from `start` for which `holds`; single rows for which it does not are passed over.
  template <typename Holds>
  [[nodiscard]] static int lastRow(int start, int direction, const Holds& holds)
  {
    int row = start;
    while (holds(row + direction) || holds(row + 2 * direction)) row += direction;
    return row;
  }

  /// As high as a goal at this distance, and not standing before the wall as a robot does. Seen from the side the
  /// colour is that of the goal's back, whose foot is farther away and so higher in the image than the corner's.
  [[nodiscard]] bool looksLikeGoal(const GoalCorner& corner) const
  {
    const Eigen::Vector2d& position = corner.measured.position;
    const auto foot = camera_.pixelOf(position), top = camera_.pixelOf(position, settings_.goal_height);
    if (!foot || !top) return false;
    const double expected = foot->y - top->y, seen = corner.row_bottom - corner.row_top;
    const double tolerance = settings_.height_tolerance * expected + kEndOfRows;
    if (seen > expected + tolerance || corner.row_bottom > corner.white_bottom + tolerance) return false;
    // The foot of a near goal may be below the image.
    if (corner.white_bottom >= left_.rows - 1) return true;
    const double at_back = expected * position.x() / (position.x() + settings_.goal_depth);
    return seen >= at_back - tolerance && std::abs(corner.white_bottom - corner.row_top - expected) <= tolerance;
  }

  const cv::Mat& left_;
  const cv::Mat& right_;
  const StereoCamera& camera_;
  const GoalCornerSettings& settings_;
  cv::Vec3f least_white_;
};
}  // namespace

std::vector<GoalCorner> findGoalCorners(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera,
                                        const GoalCornerSettings& settings)
{
  const CornerFinder finder(left, right, camera, settings);
  std::vector<GoalCorner> corners;
  for (const CornerCandidate& candidate : scanForGoals(left, settings))
  {
    const auto corner = finder.at(candidate);
    if (!corner) continue;
    const bool known = std::any_of(corners.begin(), corners.end(),
                                   [&](const GoalCorner& c) {
                                     return c.colour == corner->colour && c.side == corner->side &&
                                            std::abs(c.u_left - corner->u_left) < kWindow;
                                   });
    if (!known) corners.push_back(*corner);
  }
  const auto isAmbiguous = [all = corners](const GoalCorner& c)
  {
    return 1 < std::count_if(all.begin(), all.end(),
                             [&](const GoalCorner& o) { return o.colour == c.colour && o.side == c.side; });
  };
  corners.erase(std::remove_if(corners.begin(), corners.end(), isAmbiguous), corners.end());
  return corners;
}
}  // namespace mrpt_ext
