#include "mrpt_ext/vision/stereo/floor_lines.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kDirections = 60;      ///< of half a turn
constexpr double kDistance = 0.005;  ///< [m] width of a cell
constexpr double kOff = 0.005;       ///< [m] a point may be off its line, beside half a pixel
constexpr double kGap = 0.04;        ///< [m] within one line, beside three pixels
constexpr int kLeastPoints = 5;
constexpr double kLeastLength = 0.012;  ///< [m] beside three pixels
constexpr int kMostLines = 40;
constexpr double kDirectionStep = kPi / kDirections;

/// Directions [first, last] (cells of half a turn, last may run beyond it) in which a point's line may run.
struct Sector
{
  int first = 0, last = 0;
};

Sector sectorOf(const MarkingPoint& point)
{
  const double a = std::atan2(point.along_a.y(), point.along_a.x()),
               b = std::atan2(point.along_b.y(), point.along_b.x());
  double turn = std::remainder(b - a, kPi);
  const double from = turn < 0 ? a + turn : a;
  turn = std::abs(turn);
  const int first = static_cast<int>(std::floor(from / kDirectionStep));
  const int last = static_cast<int>(std::ceil((from + turn) / kDirectionStep));
  return {first, std::min(last, first + kDirections - 1)};
}

class Hough
{
 public:
  Hough(const std::vector<MarkingPoint>& points, double max_range)
      : points_(points),
        cells_(2 * static_cast<int>(std::ceil(max_range / kDistance)) + 3),
        votes_(static_cast<std::size_t>(kDirections * cells_), 0),
        free_(points.size(), true)
  {
    for (int k = 0; k < kDirections; ++k) cosines_.push_back(std::cos(k * kDirectionStep));
    for (int k = 0; k < kDirections; ++k) sines_.push_back(std::sin(k * kDirectionStep));
    for (const MarkingPoint& p : points_) sectors_.push_back(sectorOf(p));
    for (std::size_t i = 0; i < points_.size(); ++i) vote(i, 1);
  }

  [[nodiscard]] std::vector<FloorLine> lines()
  {
    std::vector<FloorLine> found;
    while (static_cast<int>(found.size()) < kMostLines)
    {
      const auto best = std::max_element(votes_.begin(), votes_.end());
      if (*best < kLeastPoints) break;
      const int cell = static_cast<int>(best - votes_.begin());
      std::vector<std::size_t> run = longestRun(cell / cells_, cell % cells_);
      if (run.size() < static_cast<std::size_t>(kLeastPoints))
      {
        *best = 0;
        continue;
      }
      const FloorLine line = fit(run);
      for (const std::size_t i : run) free_[i] = false, vote(i, -1);
      *best = 0;
      if (line.last - line.first > kLeastLength) found.push_back(line);
    }
    return found;
  }

 private:
  [[nodiscard]] double distance(std::size_t i, int k) const
  {
    const auto d = static_cast<std::size_t>(k);
    return cosines_[d] * points_[i].position.y() - sines_[d] * points_[i].position.x();
  }
  [[nodiscard]] int cellOf(double distance) const
  {
    return static_cast<int>(std::lround(distance / kDistance)) + cells_ / 2;
  }

  void vote(std::size_t i, int amount)
  {
    for (int j = sectors_[i].first; j <= sectors_[i].last; ++j)
    {
      const int k = ((j % kDirections) + kDirections) % kDirections;
      int& votes = votes_[static_cast<std::size_t>(k * cells_ + cellOf(distance(i, k)))];
      votes = std::max(0, votes + amount);
    }
  }

  [[nodiscard]] bool mayRun(std::size_t i, int k) const
  {
    const int from_first = (((k - sectors_[i].first) % kDirections) + kDirections) % kDirections;
    return from_first <= sectors_[i].last - sectors_[i].first;
  }

  /// The longest run of points of a cell without a gap.
  [[nodiscard]] std::vector<std::size_t> longestRun(int k, int cell) const
  {
    const double middle = (cell - cells_ / 2) * kDistance;
    const Eigen::Vector2d direction(cosines_[static_cast<std::size_t>(k)], sines_[static_cast<std::size_t>(k)]);
    std::vector<std::pair<double, std::size_t>> along;
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
      if (!free_[i] || !mayRun(i, k)) continue;
      if (std::abs(distance(i, k) - middle) > kOff + 0.5 * pixelAcross(points_[i].footprint, direction)) continue;
      along.emplace_back(direction.dot(points_[i].position), i);
    }
    std::sort(along.begin(), along.end());
    std::vector<std::size_t> run, best;
    for (std::size_t j = 0; j < along.size(); ++j)
    {
      const double pixel = pixelAlong(points_[along[j].second].footprint, direction);
      if (j > 0 && along[j].first - along[j - 1].first > kGap + 3 * pixel) run.clear();
      run.push_back(along[j].second);
      if (run.size() > best.size()) best = run;
    }
    return best;
  }

  /// Total least squares.
  [[nodiscard]] FloorLine fit(const std::vector<std::size_t>& run) const
  {
    FloorLine line;
    line.points = static_cast<int>(run.size());
    for (const std::size_t i : run) line.middle += points_[i].position / static_cast<double>(run.size());
    double xx = 0, xy = 0, yy = 0;
    for (const std::size_t i : run)
    {
      const Eigen::Vector2d d = points_[i].position - line.middle;
      xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    line.direction = {std::cos(angle), std::sin(angle)};
    for (const std::size_t i : run)
    {
      const double along = line.direction.dot(points_[i].position - line.middle);
      line.first = std::min(line.first, along), line.last = std::max(line.last, along);
    }
    return line;
  }

  const std::vector<MarkingPoint>& points_;
  int cells_;
  std::vector<int> votes_;
  std::vector<bool> free_;
  std::vector<Sector> sectors_;
  std::vector<double> cosines_, sines_;
};
}  // namespace

std::vector<FloorLine> findFloorLines(const std::vector<MarkingPoint>& points, double max_range)
{
  return Hough(points, max_range).lines();
}
}  // namespace mrpt_ext
