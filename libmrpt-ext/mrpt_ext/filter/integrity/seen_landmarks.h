#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// The landmarks that the pose hypothesis has seen: its counterpart of the features that a null model tracks
/// (feature_mixture.h).
///
/// Far fewer landmarks are seen than are in view: others are hidden, face away or are too faint. Those that were seen
/// are seen again and again, which either hypothesis expects. If the pose hypothesis spread its detections over the
/// whole map instead, each one of a tracked feature would speak against it by the logarithm of the number of landmarks,
/// at the right pose as well. So under either hypothesis a detection shows something new with the frequency of that so
/// far (Laplace's rule of succession), and otherwise something that was seen before.
class SeenLandmarks
{
 public:
  void clear() { *this = {}; }
  /// The landmark was seen, which is no surprise. Those not seen for longest are forgotten.
  void add(std::size_t landmark);
  /// A detection showed the landmark, or none of the map.
  void count(std::optional<std::size_t> landmark);
  /// Adds the log-likelihood of the only detection, an anonymous one with range and bearing, to that of every pose.
  void score(const Reading& part, const LandmarkTable& map, const Vector2d& origin, const PoseBatch& poses,
             std::span<float> log_likelihood) const;

 private:
  std::vector<std::size_t> indices_;  // in the map, the one seen last is the last one
  double count_ = 0, new_ = 0;        // detections
};
}  // namespace mrpt_ext
