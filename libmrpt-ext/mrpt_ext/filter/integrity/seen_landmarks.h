#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/filter/integrity/feature_mixture.h"
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
/// at the right pose as well. So a detection shows something new with the probability that the null model gives to
/// that, and otherwise a landmark that was seen before: each with the share of one feature where detections have
/// ranges, and all of them together where they are bearings. A bearing that the null model recognizes is not expected
/// of a landmark that was not seen yet.
class SeenLandmarks
{
 public:
  void clear() { *this = {}; }
  /// The landmark was seen. Those not seen for longest are forgotten.
  void add(std::size_t landmark);
  /// Adds the log-likelihood of the only detection, an anonymous one with a bearing, to that of every pose.
  /// `expected`: by the null model.
  void score(const Reading& part, const LandmarkTable& map, const Vector2d& origin, const PoseBatch& poses,
             const FeatureMixture::Outcome& expected, std::span<float> log_likelihood) const;

 private:
  /// Those of them that the detection may show.
  [[nodiscard]] LandmarkTable seenOf(const Detection& detection, const LandmarkTable& map) const;
  /// All others of the map.
  [[nodiscard]] LandmarkTable unseen(const LandmarkTable& map) const;

  std::vector<std::size_t> indices_;  // in the map, the one seen last is the last one
};
}  // namespace mrpt_ext
