#pragma once

#include "mrpt_ext/settings/settings.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// The scenario that an .ini file with simulatorKeys() describes. Throws InputError (configuration) where values
/// contradict each other, InputError (data) for a map file that cannot be read.
[[nodiscard]] Scenario readScenario(const Settings& settings);

/// Its part about one sensor, [Sensor_<label>].
[[nodiscard]] SimulatedSensor readSimulatedSensor(const Settings& settings, const std::string& section);
}  // namespace mrpt_ext
