#include "mrpt_ext/diagnosis/configured_model.h"

#include <cmath>

#include "mrpt_ext/diagnosis/bias_parameter.h"

namespace mrpt_ext
{
RecordingModel configuredModel(const std::vector<std::string>& sensors, const std::vector<CalibrationUnknown>& unknowns,
                               const LocalizationConfig& config)
{
  RecordingModel model;
  for (const CalibrationUnknown& unknown : unknowns)
  {
    AssumedError error{.unknown = unknown};
    double variance = 0, walk = 0;
    for (const BiasState& bias : config.biases)
    {
      if (!isTheSame(bias, unknown, sensors[unknown.sensor])) continue;
      error.mean += bias.mean;
      variance += square(bias.std);
      walk += square(bias.std_per_sqrt_s);
    }
    error.std = std::sqrt(variance);
    error.std_per_sqrt_s = std::sqrt(walk);
    model.errors.push_back(error);
  }
  for (const std::string& label : sensors)
    model.sensors.push_back({.outliers = configOf(config.frames.sensors, label).clutter_probability});
  return model;
}
}  // namespace mrpt_ext
