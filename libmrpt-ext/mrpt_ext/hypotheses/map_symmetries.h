#pragma once

#include <cstddef>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A rigid motion of the plane that brings many landmarks of a map to places of others.
struct MapSymmetry
{
  Pose2 motion;             ///< a robot at compose(motion, x) sees nearly what one at x sees
  std::size_t matched = 0;  ///< landmarks that it brings to places of others
  /// What a robot at compose(motion, x) sees, as if it were at x: the landmarks of the map, in its order, moved back.
  /// One that comes to the place of a landmark is put there exactly: the two cannot be told apart, however well the map
  /// is surveyed. Each keeps its identity, its category and the direction in which it faces.
  LandmarkTable image;
};

/// At most this many symmetries are found, those that match most.
inline constexpr std::size_t kMostSymmetries = 16;
/// In maps of more landmarks no symmetries are sought.
inline constexpr std::size_t kMostForSymmetries = 300;

/// The motions after which half of the landmarks have a counterpart: another one that is brought to their place, or
/// whose place they are brought to. Two copies of a room are such halves. At least five are matched, or half of fewer
/// than ten, within a quarter of the distance of neighbours, 0.25 m at most. Most matched ones come first. The identity
/// is none of them, nor what is within twice the tolerance of it or of a better one all over the map. Mirror images are
/// not motions of a robot. Identities and categories do not count: not every sensor reports them, and those that do
/// tell the places apart by them.
///
/// Pairs of near landmarks are brought to all pairs of the same length, and the matches grow from there, the nearest
/// landmarks first. The pairs start at forty landmarks chosen at random (if a quarter of the landmarks are matched,
/// that misses a motion in one map of a thousand), or at all of fewer. Deterministic.
[[nodiscard]] std::vector<MapSymmetry> mapSymmetries(const LandmarkTable& map);
}  // namespace mrpt_ext
