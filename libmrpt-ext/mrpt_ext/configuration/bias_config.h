#pragma once

#include <string>

#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/settings/key_table.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// Keys of the systematic errors that are estimated beside the pose: [Bias] for odometry and for what all sensors
/// share, [Sensor_<label>] for what one sensor has of its own on top of that.
[[nodiscard]] KeyTable biasKeys();

/// Key of what an error of this kind is taken for at the start.
[[nodiscard]] std::string biasMeanKey(BiasKind kind);

/// The errors that the settings ask for: those of [Bias] first, then those of the sensors in the order of the file.
/// What is known beforehand belongs into bias_range_m, odometry_scale and their like, which is taken off the
/// measurements; the errors here are what is left. Throws InputError (configuration) for more than the filters hold.
[[nodiscard]] BiasModel biasModel(const Settings& settings);
}  // namespace mrpt_ext
