#pragma once

#include "mrpt_ext/settings/key_table.h"

namespace mrpt_ext
{
/// The keys of landmark-simulator's .ini files.
[[nodiscard]] KeyTable simulatorKeys();

/// Its part about sensors, [Sensor_<label>].
[[nodiscard]] KeyTable simulatedSensorKeys();
}  // namespace mrpt_ext
