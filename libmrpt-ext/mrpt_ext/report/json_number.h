#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace mrpt_ext
{
/// A number with at most `decimals` digits behind the point, so that its text is short; null when it is not finite.
[[nodiscard]] inline nlohmann::ordered_json rounded(double value, int decimals)
{
  const double scale = std::pow(10.0, decimals);
  if (!std::isfinite(value) || std::abs(value) * scale > 1e15) return nullptr;
  const double kept = std::round(value * scale) / scale;
  return kept == 0 ? nlohmann::ordered_json(0) : nlohmann::ordered_json(kept);
}
}  // namespace mrpt_ext
