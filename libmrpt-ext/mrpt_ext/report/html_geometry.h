#pragma once

#include <string>

#include "mrpt_ext/evaluation/errors_by_geometry.h"

namespace mrpt_ext
{
/// Errors of all methods against the geometry, quantity by quantity: a drawing with the median errors (bars up to the
/// 95 % quantile) and a table with the share of frames that a method answered, so that it is seen where closed forms
/// fail. Oracles are left to the table above. Empty without errors.
[[nodiscard]] std::string errorsByGeometrySection(const std::vector<ErrorsByGeometry>& tables, const RunScore& score);
}  // namespace mrpt_ext
