#pragma once

#include <vector>

#include "movis_lattice.h"
#include "mrpt_ext/solvers/origin_correction.h"

namespace mrpt_ext::papers
{
/// Where the robot of paper 001 saw the poles at one point, in its own frame (x to the right) [m].
struct RebuiltPoint
{
  Vector2d p{0, 0}, q{0, 0};
  double slope_before = 0, slope_after = 0;  ///< beta of eq 5 [rad], without and with eq 8
  double misfit = 0;                         ///< [m] by which no slope turns the right pole to where table 2 has it
};

/// What tables 2 to 4 of paper 001 tell of the measurements behind them. Table 4 is the sum of tables 1 and 3, turned
/// by the slope after eq 8; this slope and table 3 give the corrected right pole. Its two factors of eq 8 are those for
/// which table 2 comes out where table 4 has no misprint; table 2 then tells the slope before eq 8. Both slopes are
/// directions from pole to pole, which gives the left pole, but for one of its two factors (the other follows from the
/// origin): the one is taken for which the left pole is seen in its true directions best, the origin left out.
struct RebuiltLattice
{
  OriginCorrection correction;
  std::vector<RebuiltPoint> points;

  /// The slants that this robot's cameras must have measured at one point; of the object by table 1.
  [[nodiscard]] MovisLook lookAt(const MovisLattice& lattice, std::size_t point) const;
};

[[nodiscard]] RebuiltLattice rebuiltFromPrint(const MovisLattice& lattice);

/// [rad] by which `seen` (robot frame) is turned against where it is for a robot put down straight at `place`.
[[nodiscard]] double turnOf(const Vector2d& seen, const Vector2d& thing, const Vector2d& place);
}  // namespace mrpt_ext::papers
