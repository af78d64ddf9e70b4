#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// How one method did in the frames of one class of geometry.
struct GeometryCell
{
  std::size_t judged = 0;      ///< estimates with an error
  OptionalNumber answered;     ///< share of the frames with an estimate
  OptionalNumber median, p95;  ///< position error [m]
};

/// Frames with like geometry.
struct GeometryClass
{
  std::string label;
  std::size_t frames = 0;
  std::vector<GeometryCell> methods;  ///< in the order of the score
};

/// Errors of all methods, sorted by one quantity of the geometry.
struct ErrorsByGeometry
{
  std::string quantity;  ///< with its unit
  std::vector<GeometryClass> classes;
};

/// Position errors from the convergence of the judged method on (else all) against the number of landmarks in view,
/// the angle over which they spread and their distance. An error belongs to the last frame at or before it, at most a
/// second old. Quantities that no frame has, and classes without frames, are left out.
[[nodiscard]] std::vector<ErrorsByGeometry> errorsByGeometry(const RunContext& context, const RunRecord& record,
                                                             const RunScore& score);
}  // namespace mrpt_ext
