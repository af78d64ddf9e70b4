#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
inline constexpr int kNoId = -1;

/// A landmark of the map, in the world frame.
struct Landmark
{
  int id = kNoId;              ///< unique, or kNoId for an anonymous landmark
  Vector3d position{0, 0, 0};  ///< [m]
  std::string category;        ///< empty: none
  Vector2d stddev{0, 0};       ///< standard deviation of x and y [m]
  /// Direction in which it faces, of its normal [rad, CCW from the x axis of the map]; absent: it faces none, or
  /// unknown.
  std::optional<double> yaw = std::nullopt;
  double std_yaw = 0;  ///< [rad], meaningful with a yaw
};

/// The landmarks of a map; keeps their order, finds them by id.
class LandmarkTable
{
 public:
  LandmarkTable() = default;
  /// Throws InputError (configuration) when an id occurs twice, or a coordinate or an angle is not finite.
  explicit LandmarkTable(std::vector<Landmark> landmarks);

  [[nodiscard]] const std::vector<Landmark>& all() const { return landmarks_; }
  [[nodiscard]] std::size_t size() const { return landmarks_.size(); }
  [[nodiscard]] bool empty() const { return landmarks_.empty(); }
  [[nodiscard]] const Landmark& operator[](std::size_t index) const { return landmarks_[index]; }
  /// Index of the landmark with this id; nothing for kNoId or an unknown id.
  [[nodiscard]] std::optional<std::size_t> indexOf(int id) const;
  /// Smallest axis-aligned box around all landmarks: {min, max}; two zeros when empty.
  [[nodiscard]] std::pair<Vector2d, Vector2d> boundingBox() const;
  /// Mean z of the landmarks [m]; 0 when empty.
  [[nodiscard]] double meanHeight() const { return mean_height_; }

 private:
  std::vector<Landmark> landmarks_;
  double mean_height_ = 0;
  std::vector<std::pair<int, std::size_t>> index_by_id_;  // sorted by id
};
}  // namespace mrpt_ext
