#pragma once

#include <cstddef>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A rigid motion of the plane that brings most landmarks of a map to places of landmarks.
struct MapSymmetry
{
  Pose2 motion;             ///< a robot at compose(motion, x) sees nearly what one at x sees
  std::size_t matched = 0;  ///< landmarks that it brings to places of others
  /// What a robot at compose(motion, x) sees, as if it were at x: the landmarks of the map, in its order, moved back.
  /// One that comes to the place of a landmark is put there exactly: the two cannot be told apart, however well the map
  /// is surveyed. Directions in which landmarks face are turned with them.
  LandmarkTable image;
};

/// At most this many symmetries are found, those that match most.
inline constexpr std::size_t kMostSymmetries = 16;
/// In maps of more landmarks no symmetries are sought.
inline constexpr std::size_t kMostForSymmetries = 300;

/// The motions that bring at least half of the landmarks, and two, to places of others, within an eighth of the spacing
/// of the landmarks, 0.25 m at most; most matched ones first. The identity is none of them, nor what is within twice
/// that tolerance of it or of a better one all over the map. Mirror images are not motions of a robot. Identities do
/// not count: where detections have some, they tell the places apart.
///
/// Pairs of landmarks chosen at random are brought to all pairs of the same length (forty of them: if half of the
/// landmarks are matched, both of a pair are with a probability of a quarter, and the motion is missed by one run in
/// 10^7). Deterministic.
[[nodiscard]] std::vector<MapSymmetry> mapSymmetries(const LandmarkTable& map);
}  // namespace mrpt_ext
