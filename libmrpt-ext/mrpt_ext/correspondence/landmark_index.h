#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// The landmarks of a map in square buckets, for queries of those near a point. Built once per map in O(N); 32
/// bytes per landmark.
class LandmarkIndex
{
 public:
  /// `bucket` [m]: side of a bucket, about the radius of the queries; 0 chooses two landmarks per bucket.
  explicit LandmarkIndex(const LandmarkTable& map, double bucket = 0);
  /// Landmarks without categories.
  explicit LandmarkIndex(std::vector<Vector2d> landmarks, double bucket = 0);

  [[nodiscard]] std::size_t size() const { return positions_.size(); }
  [[nodiscard]] bool empty() const { return positions_.empty(); }
  [[nodiscard]] const Vector2d& position(std::size_t landmark) const { return positions_[landmark]; }
  [[nodiscard]] const std::vector<Vector2d>& positions() const { return positions_; }
  /// Number of the category of a landmark; 0: it has none.
  [[nodiscard]] int category(std::size_t landmark) const { return kinds_[landmark]; }
  [[nodiscard]] int categoryCount() const { return static_cast<int>(categories_.size()); }
  /// Categories that landmarks of this map have ("none" is one of them only if some landmark has none).
  [[nodiscard]] int categoriesPresent() const { return categoryCount() - (has_uncategorized_ ? 0 : 1); }
  /// Number of a category: kAnyCategory for an empty one, kUnknownCategory for one that the map does not have.
  [[nodiscard]] int categoryOf(const std::string& category) const;
  [[nodiscard]] bool mayShow(int detection_category, std::size_t landmark) const
  {
    return detection_category == kAnyCategory || detection_category == kinds_[landmark];
  }
  /// Volume that a false detection like this one is spread over (likelihood/detection_density.h); a category counts by
  /// the number of them that the map has.
  [[nodiscard]] double measurementVolume(const AnonymousDetection& detection, const SensorModel& model) const;
  [[nodiscard]] const Vector2d& low() const { return low_; }    ///< corner of the bounding box [m]
  [[nodiscard]] const Vector2d& high() const { return high_; }  ///< opposite corner [m]

  /// Distance [m] from `point` that no landmark exceeds, rounding included.
  [[nodiscard]] double farthestFrom(const Vector2d& point) const
  {
    return (point - low_).cwiseAbs().cwiseMax((point - high_).cwiseAbs()).norm() * (1 + 1e-9);
  }

  /// Calls visit(landmark) for every landmark within `radius` [m] of `point`, in a fixed order.
  template <typename Visit>
  void forEachNear(const Vector2d& point, double radius, Visit&& visit) const
  {
    const auto [i0, i1] = span(point.x() - low_.x(), radius, columns_);
    const auto [j0, j1] = span(point.y() - low_.y(), radius, rows_);
    for (int j = j0; j <= j1; ++j)  // the buckets of a row are contiguous
    {
      const auto row = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_);
      const std::size_t end = first_[row + static_cast<std::size_t>(i1) + 1];
      for (std::size_t k = first_[row + static_cast<std::size_t>(i0)]; k < end; ++k)
        if ((in_buckets_[k] - point).squaredNorm() <= radius * radius) visit(static_cast<std::size_t>(members_[k]));
    }
  }

 private:
  void build(double bucket);
  /// First and last of `count` buckets along an axis within `radius` of `offset` [m] from the corner of the map. Beyond
  /// the edges: the bucket at the edge.
  [[nodiscard]] std::pair<int, int> span(double offset, double radius, int count) const
  {
    const double last = count - 1, from = (offset - radius) / bucket_, to = (offset + radius) / bucket_;
    if (!(from <= to)) return {0, -1};  // not finite: nothing is there
    return {static_cast<int>(std::clamp(from, 0.0, last)), static_cast<int>(std::clamp(to, 0.0, last))};
  }

  std::vector<Vector2d> positions_;
  std::vector<int> kinds_;
  bool has_uncategorized_ = false;
  std::vector<std::string> categories_;
  Vector2d low_{0, 0}, high_{0, 0};
  double bucket_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;      // per bucket, row-major, into members_; one more at the end
  std::vector<std::uint32_t> members_;  // landmarks by bucket
  std::vector<Vector2d> in_buckets_;    // their positions: neighbours in memory
};
}  // namespace mrpt_ext
