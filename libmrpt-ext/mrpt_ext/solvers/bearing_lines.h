#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/solvers/known_bearing.h"

namespace mrpt_ext
{
/// What one bearing, relative to that of landmark 0, says about f = 1 / (L_0 - R): f = r a - b', a line in the plane of
/// complex numbers (paper 000, eq 2-3).
struct BearingLine
{
  Vector2d a{0, 0};
  Vector2d b{0, 0};       ///< b' = 1 / (L_i - L_0)
  Vector2d normal{0, 0};  ///< unit normal of a
  double std = 1;         ///< of bearing i [rad]
};

/// One line per landmark except landmark 0. Requires checkBearings(...) == ok.
[[nodiscard]] std::vector<BearingLine> bearingLines(std::span<const KnownBearing> bearings);

/// r_i = |L_i - R| / |L_0 - R| on each line at f; <= 0 when the landmark would lie behind the bearing.
[[nodiscard]] std::vector<double> rangeRatios(std::span<const BearingLine> lines, const Vector2d& f);

/// R - L_0 = -1/f; nothing for f = 0 (landmark 0 infinitely far away).
[[nodiscard]] std::optional<Vector2d> robotFromReference(const Vector2d& f);
}  // namespace mrpt_ext
