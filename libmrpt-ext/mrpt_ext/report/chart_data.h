#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "mrpt_ext/evaluation/errors_by_geometry.h"
#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Data of the charts of a page. Times are in seconds since the start of the log; a number that does not exist is null,
/// and so is a chart without data. Neighbouring stamps are merged where a chart could not resolve them.

/// Position and heading errors: {t, stamps_per_entry, position: [[m] per method], heading: [[deg] per method]}.
[[nodiscard]] nlohmann::ordered_json errorData(const RunContext& context, const RunScore& score);
/// Weight of the heaviest mode and effective sample ratio of the judged method: {t, weight, ess, reseeds,
/// ambiguous: [[from, to], ...], lost: the same}.
[[nodiscard]] nlohmann::ordered_json confidenceData(const RunContext& context, const RunRecord& record);
/// {t, value, covariance: [upper triangle], low, high: 95 % band of one estimate, mean}.
[[nodiscard]] nlohmann::ordered_json neesData(const RunContext& context, const RunScore& score);
/// [{name, t, mean, std}], one per estimated bias.
[[nodiscard]] nlohmann::ordered_json biasData(const RunContext& context, const RunRecord& record);
/// [{quantity, classes: [label], median: [[m] per method], p95: the same}]; null for oracles.
[[nodiscard]] nlohmann::ordered_json geometryData(const std::vector<ErrorsByGeometry>& tables, const RunScore& score);
/// Residuals of the landmarks in standard deviations: {ids, mean, std, warning}.
[[nodiscard]] nlohmann::ordered_json residualData(const RunScore& score);
}  // namespace mrpt_ext
