#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A piece of a path along which turn, length and time pass evenly.
struct PathPiece
{
  Pose2 increment;      ///< its end in the frame of its begin
  double length = 0;    ///< [m]
  double turned = 0;    ///< [rad] sum of absolute heading changes
  double duration = 0;  ///< [s]
};

/// [m] of the radius below which a robot turns in place: half of the track of a small one, both wheels scrub.
inline constexpr double kInPlaceRadius = 0.1;

/// True for a turn while the robot drives, false for one in place.
[[nodiscard]] bool isArc(const PathPiece& piece);

/// What errors of the heading that arise along a path do to its end.
///
/// An error of the heading that arises at one place turns the rest of the path about that place: per radian the end
/// moves by the lever (-(end - place).y, (end - place).x, 1), order (x, y, phi), in axes of the path's begin. A path
/// that turns first and goes straight then has other levers than one that turns evenly.
struct PathMoments
{
  /// Sums of the levers, weighted with what an error grows with: [rad] turned, of that on arcs, [m], [s].
  Vector3d by_turn{0, 0, 0}, by_arc{0, 0, 0}, by_length{0, 0, 0}, by_time{0, 0, 0};
  /// Sums of the levers' squares, weighted with what the variance of an error grows with: [rad] turned to either side,
  /// [m], [s].
  Matrix3d turned = Matrix3d::Zero(), length = Matrix3d::Zero(), time = Matrix3d::Zero();
  /// [rad] Sum of the directions of arcs, weighted with what was turned on them to either side: how far the end moves,
  /// in [m], when the robot drives 1 m further per radian of turn.
  Vector2d along_arcs{0, 0};
};

/// Of a single piece.
[[nodiscard]] PathMoments momentsOf(const PathPiece& piece);

/// Appends a piece to a path with these moments that ends at `end` in the frame of its begin.
void append(PathMoments& moments, const Pose2& end, const PathPiece& piece);
}  // namespace mrpt_ext
