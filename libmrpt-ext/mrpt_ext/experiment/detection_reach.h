#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// How far outside the box of the map a robot may be, by the detections of its log. A robot that is outside the box of
/// possible positions is found at a wrong place inside.
///
/// Each range limits how far beyond each side of the box the robot is: by the landmark's place, plus the range. Of the
/// limits of a few seconds the 20 % quantile holds unless more than a fifth of the ranges are false.
class DetectionReach
{
 public:
  /// `map`: always the same.
  void add(const Frame& frame, const LandmarkTable& map);
  /// [m], at least 0: beyond the farthest side, the 99 % quantile over the log; where bearings come without ranges the
  /// range limit of their sensor, and without one three times the diagonal of the map, from where bearings hardly tell
  /// the distance any more. 0 with anonymous detections: those fit by chance, the more often the larger the box.
  [[nodiscard]] double metres() const;

 private:
  static constexpr std::size_t kSides = 4;
  /// A window's limits beyond the low and high side along x and y [m], by detection.
  using Limits = std::array<std::vector<double>, kSides>;

  void add(const Detection& detection, const SensorModel& model, const LandmarkTable& map);
  [[nodiscard]] static double farthest(const Limits& limits);

  std::optional<std::pair<Vector2d, Vector2d>> box_;  // of the map: low and high corner
  Limits limits_;                                     // of the last seconds
  double begin_ = 0;                                  // [s] of these
  std::map<int, std::size_t> windows_;                // before, by the limit of the farthest side in logarithmic bins
  std::size_t count_ = 0;                             // of them
  double of_bearings_ = 0;                            // [m]
  bool anonymous_ = false;
};
}  // namespace mrpt_ext
