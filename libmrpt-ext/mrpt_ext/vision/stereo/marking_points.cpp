#include "mrpt_ext/vision/stereo/marking_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPaintShare = 0.98;    ///< of the pixels are not brighter than the image's white
constexpr double kLeastNoise = 0.5;     ///< [grey levels]
constexpr double kDirectionStd = 0.10;  ///< [rad] of a gradient's direction in the image
constexpr double kSlant = 2.2;          ///< a stripe cut at a slant is so many times as wide
constexpr double kBlur = 2.5;           ///< [px] blur adds to a stripe's width
constexpr int kWallRows = 4;            ///< [px] a wall is at least as high
constexpr double kWallShare = 0.5;      ///< of a wall's height that must be bright

/// Level of white and of noise.
struct Levels
{
  double white = 0, noise = 0;
};

Levels levelsOf(const cv::Mat& whiteness)
{
  std::array<int, 256> counts{}, steps{};
  int total = 0, pairs = 0;
  for (int v = 0; v < whiteness.rows; v += 2)
  {
    const uchar* const row = whiteness.ptr<uchar>(v);
    for (int u = 0; u + 4 < whiteness.cols; u += 2)
    {
      ++counts[row[u]], ++total;
      ++steps[static_cast<std::size_t>(std::abs(row[u] - row[u + 4]))], ++pairs;
    }
  }
  const auto quantile = [](const std::array<int, 256>& histogram, double share)
  {
    int value = 0;
    for (double left = share; value < 255 && left > histogram[static_cast<std::size_t>(value)]; ++value)
      left -= histogram[static_cast<std::size_t>(value)];
    return value;
  };
  return {static_cast<double>(quantile(counts, kPaintShare * total)),
          std::max(kLeastNoise, quantile(steps, 0.5 * pairs) / kNormalMedianDeviation / std::sqrt(2.0))};
}

class PointFinder
{
 public:
  PointFinder(const cv::Mat& whiteness, const StereoCamera& camera, const MarkingSettings& settings)
      : image_(whiteness), camera_(camera), settings_(settings)
  {
    const Levels levels = levelsOf(whiteness);
    step_ = std::max(settings.min_contrast * levels.white, settings.min_significance * levels.noise);
    wall_step_ = std::max(settings.wall_contrast * levels.white, settings.min_significance * levels.noise);
    cv::GaussianBlur(whiteness, smooth_, {3, 3}, 0.8);
  }

  [[nodiscard]] MarkingPoints find() const
  {
    MarkingPoints points;
    const int first = firstRow();
    for (int v = std::max(first, 1); v + 1 < image_.rows; ++v) alongRow(v, points.stripes);
    for (int u = 1; u + 1 < image_.cols; ++u) alongColumn(u, std::max(first, 1), points);
    return points;
  }

 private:
  /// The row of the farthest floor that counts.
  [[nodiscard]] int firstRow() const
  {
    const auto farthest = camera_.pixelOf({settings_.max_range, 0});
    return farthest ? std::clamp(static_cast<int>(farthest->y), 0, image_.rows) : image_.rows;
  }
  [[nodiscard]] double at(int u, int v) const { return image_.at<uchar>(v, u); }

  /// A stripe in a run of `length` values: calls `found` with its middle and both its edges, up to `widest(i)` [px]
  /// wide.
  template <typename Value, typename Widest, typename Found>
  void eachStripe(int first, int length, const Value& value, const Widest& widest, const Found& found) const
  {
    for (int i = first + 2; i + 2 < length; ++i)
    {
      if (value(i) - value(i - 2) < step_) continue;
      const int most = static_cast<int>(widest(i)) + 2;
      // The brightest within reach, and where it has fallen again.
      int peak = i, end = i + 1;
      while (end < length && end - i <= most && value(end) > 0.5 * (value(peak) + value(i - 2)))
      {
        if (value(end) > value(peak)) peak = end;
        ++end;
      }
      if (end >= length || end - i > most) continue;
      const int before = i - 2, behind = std::min(end + 1, length - 1);
      const double floor = std::max(value(before), value(behind)), base = 0.5 * (value(before) + value(behind));
      if (value(peak) - floor < step_) continue;
      double sum = 0, weighted = 0;
      for (int k = before; k <= behind; ++k)
      {
        const double weight = std::max(0.0, value(k) - base);
        sum += weight, weighted += weight * k;
      }
      found(weighted / sum, i - 1, end);
      i = end;
    }
  }

  void alongRow(int v, std::vector<MarkingPoint>& points) const
  {
    const uchar* const row = image_.ptr<uchar>(v);
    const auto position = camera_.floorAt(cv::Point2d(camera_.cx, v));
    if (!position) return;
    const double width = settings_.line_width * camera_.fx / position->norm();
    eachStripe(
        0, image_.cols, [row](int u) { return static_cast<double>(row[u]); },
        [&](int) { return kSlant * width + kBlur; },
        [&](double middle, int begin, int end) {
          add(points, {middle, static_cast<double>(v)}, begin, v, end, v, true);
        });
  }

  void alongColumn(int u, int first, MarkingPoints& points) const
  {
    const auto value = [this, u](int v) { return at(u, v); };
    const int wall = wallAbove(u, first, points.walls);
    const auto widest = [this, u](int v)
    {
      const auto position = camera_.floorAt(cv::Point2d(u, v));
      if (!position) return kBlur;
      return kSlant * settings_.line_width * camera_.height * camera_.fy / position->squaredNorm() + kBlur;
    };
    eachStripe(std::max(first - 2, wall), image_.rows, value, widest,
               [&](double middle, int begin, int end) {
                 add(points.stripes, {static_cast<double>(u), middle}, u, begin, u, end, false);
               });
  }

  /// [px] half the height of a wall that stands at this pixel.
  [[nodiscard]] int wallRows(int u, int v) const
  {
    const auto position = camera_.floorAt(cv::Point2d(u, v));
    if (!position) return kWallRows;
    return std::max(kWallRows, static_cast<int>(kWallShare * settings_.wall_height * camera_.fy / position->x()));
  }

  /// From below to the first bright area that is no marking; its first dark row.
  int wallAbove(int u, int first, std::vector<MarkingPoint>& points) const
  {
    for (int v = image_.rows - 3; v > first && v > kWallRows; --v)
    {
      const double below = at(u, v + 1);
      if (at(u, v - 1) - below < wall_step_) continue;
      const double above = at(u, v - 2);
      const int top = v - wallRows(u, v);
      int row = v - 2;
      while (row > std::max(top, 0) && at(u, row) - below > 0.7 * (above - below)) --row;
      if (row > std::max(top, 0)) continue;
      const double half = 0.5 * (above + below);
      for (int k = v + 1; k > v - 2; --k)
      {
        const double a = at(u, k) - half, b = at(u, k - 1) - half;
        if (a >= 0 || b < 0) continue;
        add(points, {static_cast<double>(u), k - a / (a - b)}, u, v - 1, u, v, false, true);
        return v + 1;
      }
    }
    return 0;
  }

  [[nodiscard]] cv::Point2d gradient(int u, int v) const
  {
    const auto s = [&](int du, int dv)
    {
      return static_cast<double>(
          smooth_.at<uchar>(std::clamp(v + dv, 0, smooth_.rows - 1), std::clamp(u + du, 0, smooth_.cols - 1)));
    };
    return {2 * (s(1, 0) - s(-1, 0)) + s(1, 1) - s(-1, 1) + s(1, -1) - s(-1, -1),
            2 * (s(0, 1) - s(0, -1)) + s(1, 1) - s(1, -1) + s(-1, 1) - s(-1, -1)};
  }

  /// A point with the direction of the gradients at both its edges (one, of a wall).
  void add(std::vector<MarkingPoint>& points, const cv::Point2d& pixel, int u_begin, int v_begin, int u_end, int v_end,
           bool in_row, bool single = false) const
  {
    cv::Point2d normal = gradient(u_begin, v_begin);
    if (single)
      normal += gradient(u_end, v_end);
    else
      normal -= gradient(u_end, v_end);
    const double size = std::hypot(normal.x, normal.y);
    // Along a row the edges must be steeper than flat, along a column flatter than steep: the other scan sees the rest.
    if (!(size > 0) || (in_row ? std::abs(normal.x) : std::abs(normal.y)) < 0.4 * size) return;
    const auto position = camera_.floorAt(pixel);
    if (!position || position->norm() > settings_.max_range) return;
    MarkingPoint point;
    point.pixel = pixel;
    point.position = *position;
    const double angle = std::atan2(normal.x, -normal.y);  // along the line, in the image
    const auto direction = [&](double turn)
    {
      const cv::Point2d step(std::cos(angle + turn), std::sin(angle + turn));
      const auto a = camera_.floorAt(pixel + step), b = camera_.floorAt(pixel - step);
      return a && b ? Eigen::Vector2d((*a - *b).normalized()) : Eigen::Vector2d(0, 0);
    };
    point.along_a = direction(-kDirectionStd), point.along_b = direction(kDirectionStd);
    if (point.along_a.isZero() || point.along_b.isZero()) return;
    point.footprint = camera_.footprintAt(*position);
    points.push_back(point);
  }

  const cv::Mat& image_;
  const StereoCamera& camera_;
  const MarkingSettings& settings_;
  cv::Mat smooth_;
  double step_ = 0, wall_step_ = 0;
};
}  // namespace

cv::Mat whitenessOf(const cv::Mat& image)
{
  if (image.channels() == 1) return image;
  std::array<cv::Mat, 3> channels;
  cv::split(image, channels.data());
  return cv::min(channels[0], cv::min(channels[1], channels[2]));
}

MarkingPoints findMarkingPoints(const cv::Mat& whiteness, const StereoCamera& camera, const MarkingSettings& settings)
{
  return PointFinder(whiteness, camera, settings).find();
}
}  // namespace mrpt_ext
