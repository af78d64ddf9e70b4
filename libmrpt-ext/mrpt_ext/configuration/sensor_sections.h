#pragma once

#include "mrpt_ext/frames/sensor_config.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// The sections [Sensor_<label>].
[[nodiscard]] SensorConfigs sensorConfigs(const Settings& settings);

/// Reads a key of the form `1:0.12 4:-0.05`; empty where it is not set. Throws InputError (configuration) with the line
/// on anything else and on an id that occurs twice.
[[nodiscard]] LandmarkValues landmarkValues(const Settings& settings, const std::string& section,
                                            const std::string& key);
}  // namespace mrpt_ext
