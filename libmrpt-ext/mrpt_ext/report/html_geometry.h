#pragma once

#include <string>

#include "mrpt_ext/evaluation/errors_by_geometry.h"

namespace mrpt_ext
{
/// Errors of all methods by the geometry of the landmarks, quantity by quantity: a chart, and a table with median
/// errors and the share of frames in which a method gave an estimate, which shows where closed forms fail. Without
/// oracles; empty without errors.
[[nodiscard]] std::string errorsByGeometrySection(const std::vector<ErrorsByGeometry>& tables, const RunScore& score);
}  // namespace mrpt_ext
