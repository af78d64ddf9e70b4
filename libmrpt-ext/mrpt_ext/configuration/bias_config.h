#pragma once

#include <cstddef>
#include <string>

#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/settings/key_table.h"
#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// Keys of the systematic errors that are estimated beside the pose: [Bias] for odometry and for errors that all
/// sensors share, [Sensor_<label>] for those of one sensor, on top of them.
[[nodiscard]] KeyTable biasKeys();

/// Number of errors that the filters estimate at most.
inline constexpr std::size_t kMaxBiases = kMaxKalmanStates - 3;

/// Keys of the prior mean and standard deviation of an error of this kind.
[[nodiscard]] std::string biasMeanKey(BiasKind kind);
[[nodiscard]] std::string biasStdKey(BiasKind kind);

/// The errors that the settings name: those of [Bias] first, then those of the sensors in the order of the file.
/// Known errors belong into bias_range_m, odometry_scale and their like, which correct the measurements; the errors
/// here are what is left. Throws InputError (configuration) for more than the filters hold.
[[nodiscard]] BiasModel biasModel(const Settings& settings);
}  // namespace mrpt_ext
