#pragma once

#include <optional>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// The settings with what a first pass over the log has found, and the account of it.
struct AutoCalibration
{
  Settings settings;
  AdoptedCalibration adopted;
};

/// True where the configuration asks for a calibration and the log allows one: `auto_calibrate`, more than a minute of
/// frames that belong together, our own particle filter among the methods.
[[nodiscard]] bool isAutoCalibrated(const LocalizationInput& input);

/// The particle filter runs as configured (likelierTrajectory()), and where that is seldom `ok` with odometry that may
/// err (diagnosis/uncertain_odometry.h); its trajectory, the readings and odometry tell the
/// systematic errors and the noise (diagnosis/calibration_choice.h). Nothing when nothing pays. The truth serves the
/// error of the first pass in the account only. The same for any number of trials: the first pass is trial 0.
[[nodiscard]] std::optional<AutoCalibration> autoCalibration(const Settings& settings, const LocalizationInput& input,
                                                             bool show_progress);

/// The adopted values as an .ini.
[[nodiscard]] std::string calibrationIni(const AdoptedCalibration& adopted);
}  // namespace mrpt_ext
