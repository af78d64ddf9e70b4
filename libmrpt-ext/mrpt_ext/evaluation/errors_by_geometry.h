#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Errors of one method in the frames of one class of geometry.
struct GeometryCell
{
  std::size_t judged = 0;      ///< estimates with an error
  OptionalNumber estimated;    ///< share of the frames with an estimate
  OptionalNumber median, p95;  ///< position error [m]
};

/// Frames of similar geometry.
struct GeometryClass
{
  std::string label;
  std::size_t frames = 0;
  std::vector<GeometryCell> methods;  ///< in the order of the score
};

/// Errors of all methods by one quantity of the geometry.
struct ErrorsByGeometry
{
  std::string quantity;  ///< with its unit
  std::vector<GeometryClass> classes;
};

/// Position errors from the convergence of the judged method on (else all) by the number of landmarks in view, by
/// their angular spread and by their median distance. An error belongs to the last frame at or before it, at most a
/// second old. Quantities that no frame has, and classes without frames, are left out.
[[nodiscard]] std::vector<ErrorsByGeometry> errorsByGeometry(const RunContext& context, const RunRecord& record,
                                                             const RunScore& score);
}  // namespace mrpt_ext
