#include "mrpt_ext/vision/stereo/goal_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/stereo/edge_mixture.h"
#include "mrpt_ext/vision/stereo/upright_edges.h"

namespace mrpt_ext
{
namespace
{
constexpr int kWindow = 10;           ///< [px] around the candidate's column
constexpr int kInside = 4;            ///< [px] from the step to where the coloured side's height is measured
constexpr float kAsWhite = 0.6F;      ///< of the white beside the step is still it, share of each channel
constexpr int kFootReach = 10;        ///< [px] to either side that the foot is followed
constexpr int kFootPoints = 5;        ///< of a line
constexpr double kFootStep = 0.6;     ///< [px] by more a wall's foot is lower where it covers the goal
constexpr double kHollow = 140;       ///< [deg] a quarter of a turn, as badly as it can be measured
constexpr double kLeastSide = 4;      ///< [px] columns of a goal's side that can be told from its back
constexpr double kByColour = 0.2;     ///< [px] by which the blur of the colour beside it moves the turn of a narrow one
constexpr double kColourReach = 1.5;  ///< [px] of that blur
constexpr double kLeastCovered = 1;   ///< [px] of a goal's side by the wall, to be sure of it
constexpr int kSameEdge = 2;          ///< [px] an edge of which the column is known
constexpr int kSideReach = 5;         ///< [px] from the step that a narrow side is sought
constexpr int kLevelColumns = 4;      ///< [px] beyond it, that tell the level of white and of colour
constexpr double kLeastDeficit = 0.25;   ///< [px] of complete darkness that a side in the shade amounts to
constexpr double kOutlierDeficit = 2;    ///< likewise, standard deviations of the noise
constexpr double kDepthTolerance = 0.3;  ///< share of a goal's depth
constexpr double kEndOfRows = 1.5;       ///< [px] a height in the image is known to

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

EdgeSearch searchFor(const StereoCamera& camera, const GoalCornerSettings& settings)
{
  return {camera.disparityAt(settings.max_range), camera.disparityAt(settings.min_range), settings.min_rows,
          settings.std_column, settings.std_disparity};
}

class CornerFinder
{
 public:
  CornerFinder(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera,
               const GoalCornerSettings& settings)
      : left_(left), camera_(camera), settings_(settings), edges_(left, right, camera, searchFor(camera, settings))
  {
  }

  [[nodiscard]] std::optional<GoalCorner> at(const CornerCandidate& candidate) const
  {
    const GoalColour& colour = settings_.colours[static_cast<std::size_t>(candidate.colour)];
    const int margin = settings_.scan_step;
    const EdgeWindow window{candidate.first_row - margin, candidate.last_row + margin, candidate.column, kWindow};
    // A robot and a goal beside it may both agree with some disparity.
    for (const UprightEdge& edge : edges_.in(window, {&colour, candidate.side}))
      if (auto corner = cornerAt(edge, candidate); corner && isAsHighAsGoal(*corner))
      {
        moveToFoot(*corner, edge);
        if (auto front = frontOf(*corner, edge, window)) return front;
        if (!isHollow(*corner, edge.middle, colour) && !hasNarrowSide(*corner, edge)) return corner;
      }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<GoalCorner> cornerAt(const UprightEdge& edge, const CornerCandidate& candidate) const
  {
    const auto measured = measureStereo(camera_, edge.middle, edge.disparity, edge.std_column, edge.std_disparity);
    if (!measured) return std::nullopt;
    const double u = edge.middle.x, d = edge.disparity;
    GoalCorner corner{candidate.colour, candidate.side, u, u - d, 0, 0, 0, *measured};
    findHeight(corner, edge);
    return corner;
  }

  /// The columns, which are those of the edge's middle.
  void moveToFoot(GoalCorner& corner, const UprightEdge& edge) const
  {
    const double to_foot = corner.white_bottom - edge.middle.y;
    corner.u_left += to_foot * camera_.uprightSlope(edge.middle);
    corner.u_right += to_foot * camera_.uprightSlope({edge.middle.x - edge.disparity, edge.middle.y});
  }

  /// The corner of a goal with white sides, given where its side ends at the coloured back: there the wall turns, which
  /// is seen as another shade of white, as far before the back as the goal is deep.
  [[nodiscard]] std::optional<GoalCorner> frontOf(const GoalCorner& back, const UprightEdge& edge,
                                                  const EdgeWindow& window) const
  {
    const double widest = camera_.fx * settings_.goal_depth / back.measured.depth * (1 + kDepthTolerance) + kLeastSide;
    EdgeWindow beside = window;
    beside.column = edge.middle.x - back.side * (kLeastSide + widest) / 2;
    beside.reach = static_cast<int>(std::ceil((widest - kLeastSide) / 2));
    beside.first_row = edge.rows.front();
    beside.last_row = std::min(edge.rows.back(), static_cast<int>(back.white_bottom));  // not on a glossy floor
    for (const int darker : {back.side, -back.side})
      for (const double column : edges_.columnsIn(beside, {nullptr, darker}))
      {
        EdgeWindow narrow = beside;
        narrow.column = column, narrow.reach = kSameEdge;
        for (UprightEdge turn : edges_.in(narrow, {nullptr, darker}))
        {
          const double side = std::abs(edge.middle.x - turn.middle.x);
          const double by_colour = kByColour * std::exp(-square((side - kLeastSide) / kColourReach) / 2);
          turn.std_column = std::hypot(turn.std_column, by_colour);
          turn.std_disparity = std::hypot(turn.std_disparity, by_colour);
          auto front = cornerAt(turn, {back.colour, back.side, 0, 0, 0});
          if (!front) continue;
          const double apart = (front->measured.position - back.measured.position).norm();

          const double std = std::hypot(front->measured.std_range, back.measured.std_range);
          moveToFoot(*front, turn);
          front->side_width = side;
          if (front->measured.range < back.measured.range &&
              std::abs(apart - settings_.goal_depth) < kDepthTolerance * settings_.goal_depth + 2 * std)
            return front;
        }
      }
    return std::nullopt;
  }

  /// How far the coloured side reaches up and down from the rows that were measured, and how far down the white one.
  void findHeight(GoalCorner& corner, const UprightEdge& edge) const
  {
    const GoalColour& colour = settings_.colours[static_cast<std::size_t>(corner.colour)];
    const cv::Point2d& middle = edge.middle;
    const auto& rows = edge.rows;
    const auto beside = [&](int row, int offset)
    {
      const double u = middle.x + camera_.uprightSlope(middle) * (row - middle.y) + corner.side * offset;
      return meanAround(left_, row, std::clamp(static_cast<int>(std::lround(u)), 0, left_.cols - 1));
    };
    cv::Vec3f white(0, 0, 0);
    for (const int row : rows) white += beside(row, -kInside) * (1.F / static_cast<float>(rows.size()));
    const auto inImage = [this](int row) { return row >= 0 && row < left_.rows; };
    const auto isColoured = [&](int row) { return inImage(row) && colour.matches(white, beside(row, kInside)); };
    const auto isAsWhite = [&](int row) { return inImage(row) && isWhite(beside(row, -kInside), kAsWhite * white); };
    const int start = rows[rows.size() / 2];
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

  /// The row in which what `belongs` to a wall ends downwards (`direction` 1) or upwards (-1), to a fraction: half way
  /// to the level of what is beyond.
  template <typename Belongs>
  [[nodiscard]] std::optional<double> endAt(const cv::Point2d& edge, int offset, int direction,
                                            const Belongs& belongs) const
  {
    const auto level = [&](int row)
    {
      const auto pixel = beside(edge, row, offset);
      return pixel ? std::optional(std::max({(*pixel)[0], (*pixel)[1], (*pixel)[2]})) : std::nullopt;
    };
    const int last = lastRow(static_cast<int>(std::lround(edge.y)), direction,
                             [&](int row)
                             {
                               const auto pixel = beside(edge, row, offset);
                               return pixel && belongs(*pixel);
                             });
    const auto wall = level(last - 2 * direction), beyond = level(last + 3 * direction);
    if (!wall || !beyond) return std::nullopt;
    const float half = 0.5F * (*wall + *beyond);
    for (int i = -1; i <= 2; ++i)
      if (const float here = *level(last + i * direction), next = *level(last + (i + 1) * direction);
          here >= half && next < half)
        return last + direction * (i + static_cast<double>((here - half) / (here - next)));
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
      if (const auto row = endAt(edge, corner.side * offset, 1,
                                 [&](const cv::Vec3f& pixel) { return colour.matches(*white, pixel); }))
        of_colour.add(offset, *row);
      if (const auto row = endAt(edge, -corner.side * offset, 1,
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

  /// Linear light (up to a factor) of a pixel beside an edge; nothing beyond the image.
  [[nodiscard]] std::optional<cv::Vec3d> lightBeside(const GoalCorner& corner, const UprightEdge& edge, int row,
                                                     int offset) const
  {
    const double u = edge.middle.x + camera_.uprightSlope(edge.middle) * (row - edge.middle.y);
    const int column = cvRound(u) + corner.side * offset;
    if (column < 0 || column >= left_.cols) return std::nullopt;
    return lightOf(left_.at<cv::Vec3b>(row, column));
  }

  /// Mean over an edge's rows and some columns beside it.
  [[nodiscard]] std::optional<cv::Vec3d> levelBeside(const GoalCorner& corner, const UprightEdge& edge,
                                                     int offset) const
  {
    cv::Vec3d sum(0, 0, 0);
    for (const int row : edge.rows)
      for (int i = 0; i < kLevelColumns; ++i)
        if (const auto light = lightBeside(corner, edge, row, offset + i))
          sum += *light;
        else
          return std::nullopt;
    return sum / static_cast<double>(kLevelColumns * edge.rows.size());
  }

  /// Whether a white side in the shade lies between white and colour, too narrow to show where it begins: what is
  /// measured then is the goal's back. A side in the shade takes light away, a white one from pixels that are rather
  /// white, a coloured one from the others.
  [[nodiscard]] bool hasNarrowSide(const GoalCorner& corner, const UprightEdge& edge) const
  {
    const auto white = levelBeside(corner, edge, -kSideReach - kLevelColumns),
               dyed = levelBeside(corner, edge, kInside);
    if (!white || !dyed) return false;
    const EdgeMixture mixture(*white, *dyed);
    const double rows = static_cast<double>(edge.rows.size());
    double missing = 0, squares = 0, of_white = 0;
    for (const int row : edge.rows)
    {
      double in_row = 0;
      for (int offset = -kSideReach; offset < kInside; ++offset)
        if (const auto light = lightBeside(corner, edge, row, offset))
        {
          const double dark = mixture.darkIn(*light);
          in_row += dark, of_white += mixture.whiteIn(*light) * dark / rows;
        }
      missing += in_row / rows, squares += in_row * in_row / rows;
    }
    const double std = std::sqrt((squares - missing * missing) / rows);
    return missing > std::max(kLeastDeficit, kOutlierDeficit * std) && of_white > 0.5 * missing;
  }

  /// The last row up or down from `start` for which `holds`; single rows for which it does not are passed over.
  template <typename Holds>
  [[nodiscard]] static int lastRow(int start, int direction, const Holds& holds)
  {
    int row = start;
    while (holds(row + direction) || holds(row + 2 * direction)) row += direction;
    return row;
  }

  /// As high as a goal at this distance, or twice that where the floor mirrors it, and not standing before the wall as
  /// a robot does. Seen from the side the colour is that of the goal's back, whose foot is farther away and so higher
  /// in the image than the corner's.
  [[nodiscard]] bool isAsHighAsGoal(GoalCorner& corner) const
  {
    const Eigen::Vector2d& position = corner.measured.position;
    const auto foot = camera_.pixelOf(position), top = camera_.pixelOf(position, settings_.goal_height);
    if (!foot || !top) return false;
    const double expected = foot->y - top->y, seen = corner.row_bottom - corner.row_top;
    const double at_back = expected * position.x() / (position.x() + settings_.goal_depth);
    const double tolerance = settings_.height_tolerance * expected + kEndOfRows;
    if (seen >= 2 * at_back - tolerance && seen <= 2 * expected + tolerance)
    {  // What is white below the mirrored wall may be the mirrored hall; the top is where a goal's is.
      corner.white_bottom = corner.row_top + expected;
      return std::abs(corner.row_top - top->y) <= tolerance;
    }
    if (seen > expected + tolerance || corner.row_bottom > corner.white_bottom + tolerance) return false;
    // The foot of a near goal may be below the image.
    if (corner.white_bottom >= left_.rows - 1) return true;
    return seen >= at_back - tolerance && std::abs(corner.white_bottom - corner.row_top - expected) <= tolerance;
  }

  const cv::Mat& left_;
  const StereoCamera& camera_;
  const GoalCornerSettings& settings_;
  UprightEdges edges_;
};

/// Both sides of a goal are white if one is. Together they are as wide in the image as the goal's back is narrower than
/// its front; what is left of that beside the one that is seen is the other one's, unless the wall covers it.
bool maybeHasUnseenSide(const GoalCorner& corner, const std::vector<GoalCorner>& all, double depth)
{
  if (corner.side_width > 0) return false;
  return std::any_of(all.begin(), all.end(),
                     [&](const GoalCorner& other)
                     {
                       if (other.colour != corner.colour || other.side == corner.side || !(other.side_width > 0))
                         return false;
                       const Eigen::Vector2d along = corner.measured.position - other.measured.position;
                       const double front = 0.5 * (corner.measured.depth + other.measured.depth);
                       const double deeper = depth * std::abs(along.y()) / along.norm();
                       const double both = std::abs(corner.u_left - other.u_left) * deeper / (front + deeper);
                       return both - other.side_width > -kLeastCovered;
                     });
}
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
  std::erase_if(corners, isAmbiguous);
  std::erase_if(corners,
                [&, all = corners](const GoalCorner& c) { return maybeHasUnseenSide(c, all, settings.goal_depth); });
  return corners;
}
}  // namespace mrpt_ext
