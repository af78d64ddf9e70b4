#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// Decimals of the columns of all CSV files that a run leaves.
inline constexpr int kTimeDecimals = 6;        ///< [s]
inline constexpr int kLengthDecimals = 6;      ///< [m]
inline constexpr int kAngleDecimals = 6;       ///< [deg]
inline constexpr int kCovarianceDecimals = 9;  ///< [m^2, m rad, rad^2]
inline constexpr int kShareDecimals = 6;

[[nodiscard]] inline std::string timeField(double seconds) { return fixedText(seconds, kTimeDecimals); }
[[nodiscard]] inline std::string lengthField(double metres) { return fixedText(metres, kLengthDecimals); }
[[nodiscard]] inline std::string angleField(double radians) { return fixedText(radToDeg(radians), kAngleDecimals); }
[[nodiscard]] inline std::string covarianceField(double value) { return fixedText(value, kCovarianceDecimals); }
[[nodiscard]] inline std::string shareField(double share) { return fixedText(share, kShareDecimals); }

/// Text as a CSV field: quoted only where a comma, a quote or a line break needs it.
[[nodiscard]] inline std::string textField(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
}  // namespace mrpt_ext
