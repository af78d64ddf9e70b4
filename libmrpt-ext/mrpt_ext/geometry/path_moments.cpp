#include "mrpt_ext/geometry/path_moments.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
Vector2d leftOf(const Vector2d& v) { return {-v.y(), v.x()}; }

/// The end of the path has moved by `by`.
void moveEnd(PathMoments& moments, const Vector2d& by)
{
  Matrix3d shift = Matrix3d::Identity();
  shift.topRightCorner<2, 1>() = leftOf(by);
  for (Vector3d* sum : {&moments.by_turn, &moments.by_arc, &moments.by_length, &moments.by_time})
    *sum = (shift * *sum).eval();
  for (Matrix3d* sum : {&moments.turned, &moments.length, &moments.time})
    *sum = (shift * *sum * shift.transpose()).eval();
}

/// `chord`: its displacement in the axes of the path's begin.
void add(PathMoments& moments, const PathPiece& piece, const Vector2d& chord)
{
  const Vector2d swing = leftOf(chord);
  const Vector3d lever(0.5 * swing.x(), 0.5 * swing.y(), 1);  // its mean over the piece
  Matrix3d squared = lever * lever.transpose();
  squared.topLeftCorner<2, 2>() += swing * swing.transpose() / 12;
  moments.by_turn += piece.increment.phi * lever;
  if (isArc(piece))
  {
    moments.by_arc += piece.increment.phi * lever;
    moments.along_arcs += piece.turned * chord.stableNormalized();
  }
  moments.by_length += piece.length * lever;
  moments.by_time += piece.duration * lever;
  moments.turned += piece.turned * squared;
  moments.length += piece.length * squared;
  moments.time += piece.duration * squared;
}
}  // namespace

bool isArc(const PathPiece& piece) { return piece.length > kInPlaceRadius * piece.turned; }

PathMoments momentsOf(const PathPiece& piece)
{
  PathMoments moments;
  add(moments, piece, piece.increment.position());
  return moments;
}

void append(PathMoments& moments, const Pose2& end, const PathPiece& piece)
{
  const Vector2d chord = rotation(end.phi) * piece.increment.position();
  moveEnd(moments, chord);
  add(moments, piece, chord);
}
}  // namespace mrpt_ext
