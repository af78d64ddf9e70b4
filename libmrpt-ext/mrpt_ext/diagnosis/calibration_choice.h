#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/calibration/predictive_likelihood.h"
#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// Noise that a calibration may change beside the systematic errors.
struct NoiseChoice
{
  PerMotionNoise<bool> odometry{false, false};
  std::vector<bool> bearings, ranges, outliers;  ///< by sensor
};

/// The part of a calibration that is worth adopting.
struct CalibrationChoice
{
  std::vector<CalibrationUnknown> errors;
  std::vector<CalibrationUnknown> beside;  ///< to be estimated with them; lever arms are adopted where they differ
  NoiseChoice noise;
  /// Mean log density of a reading of the second half: as configured, and with what was estimated from the first. A
  /// reading that no landmark is near adds the log probability of an outlier.
  double configured = 0, calibrated = 0;
  [[nodiscard]] bool empty() const;
};

/// What of `unknowns` and of the noise to adopt: estimated from the first half of the recording, it must predict the
/// second half better than without it (calibration/predictive_likelihood.h). Starts with everything that the first half
/// tells by two standard deviations, beside the others. What does not pay is taken out, the worst first; the
/// others are then estimated anew. The gain that is required falls from two of its standard deviations, for an error
/// that the first half tells by two of its own, to zero at four. Where errors of sensors and of odometry together
/// predict better than none of them, one stays unless the prediction is worse with it by one standard deviation, but a
/// lever arm has to pay. Of offset and scale of radios, which the first half may not tell from each other, one may stay
/// alone. Errors that the filters estimate anyway stay uncertain in the comparison.
[[nodiscard]] CalibrationChoice chooseCalibration(const CalibrationData& data,
                                                  const std::vector<CalibrationUnknown>& unknowns,
                                                  const LocalizationConfig& config);
}  // namespace mrpt_ext
