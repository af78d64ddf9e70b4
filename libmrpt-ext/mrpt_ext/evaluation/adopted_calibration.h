#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/verdict_history.h"
#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
/// A value of the configuration that was replaced by its estimate from the log.
struct CalibratedValue
{
  std::string section, key, value;  ///< as in an .ini
  double std = 0;                   ///< of the estimate, in the unit of the key; 0: none
};

/// "0.12", or nothing without a deviation.
[[nodiscard]] inline std::string deviationText(const CalibratedValue& value)
{
  return value.std > 0 ? formatted("%.2g", value.std) : "";
}

/// The value, and after `separator` "+- 0.12" where it has a deviation.
[[nodiscard]] inline std::string withDeviation(const CalibratedValue& value, const std::string& separator)
{
  const std::string deviation = deviationText(value);
  return deviation.empty() ? value.value : value.value + separator + "+- " + deviation;
}

/// A run with one configuration, by its own evidence; the error is for the reader alone.
struct CalibrationRow
{
  std::optional<double> log_density;  ///< mean over the readings of the second half of the log
  Verdict verdict = Verdict::lost;
  VerdictShares shares;
  std::optional<double> position_rmse_m;  ///< where there is a ground truth
};

/// What a run took over from a first pass over its log.
struct AdoptedCalibration
{
  std::vector<CalibratedValue> values;
  /// The pass as configured; log density along the trajectory calibrated from, if that is of this configuration.
  CalibrationRow before;
  std::optional<double> log_density_after;  ///< with values from the first half of the log
};
}  // namespace mrpt_ext
