#pragma once

#include <array>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Three directed bearings to three known landmarks: exactly one pose, or none.
struct BearingTriple
{
  enum class Outcome
  {
    pose,    ///< one pose
    behind,  ///< none: a landmark would lie behind its bearing, by more than the bearings' error
    open     ///< within the bearings' error of being singular or behind: nothing can be said
  };
  Outcome outcome = Outcome::open;
  Vector2d position{0, 0};  ///< world frame, set with a pose
  double phi = 0;           ///< heading [rad], set with a pose
};

/// Paper 000, eq 1-6, for exactly three bearings, where it has no residual: two lines in the plane of f cross (a cross
/// product instead of a matrix inverse; one arc tangent in all). `unit_bearings` are (cos b, sin b); `error` is the
/// largest error of a bearing [rad], 0 for the plain question.
[[nodiscard]] BearingTriple solveBearingTriple(const std::array<Vector2d, 3>& landmarks,
                                               const std::array<Vector2d, 3>& unit_bearings, double error);
}  // namespace mrpt_ext
