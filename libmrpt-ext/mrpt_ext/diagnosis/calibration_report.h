#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/diagnosis/calibration_data.h"
#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/settings/ini_edit.h"

namespace mrpt_ext
{
/// A figure of the configuration, and what the log says about it.
struct CalibrationFinding
{
  std::string what;     ///< "camera: bearings too large by"
  std::string unit;     ///< of the three figures, those of the .ini
  double now = 0;       ///< what the configuration says
  double estimate = 0;  ///< what the log says
  double std = 0;
  int decimals = 3;
  std::string why_not;   ///< why the log does not tell it; empty: it does
  IniAssignment line;    ///< that sets it
  bool differs = false;  ///< the line is to be set
};

/// The errors that were found on top of the configuration's own corrections, as figures of the configuration.
/// A figure that [Bias] or [Sensor_<label>] gives as the mean of an estimated error is told as that mean. Only the
/// difference of two clocks shows: it is blamed on odometry where the configuration does so and there is one sensor,
/// else on the sensor. A line is to be set when the log differs by more than two deviations; offset and scale of a
/// range belong together.
[[nodiscard]] std::vector<CalibrationFinding> doctorFindings(const RecordingErrors& errors,
                                                             const std::vector<std::string>& sensors,
                                                             const LocalizationConfig& config);

/// How readings scatter and how many of them are outliers, by sensor; a line where the configuration promises less.
[[nodiscard]] std::vector<CalibrationFinding> scatterFindings(const RecordingErrors& errors,
                                                              const CalibrationData& examined,
                                                              const LocalizationConfig& config);

/// Shares of outliers by landmark, one line each.
[[nodiscard]] std::vector<std::string> landmarkLines(const RecordingErrors& errors, const CalibrationData& examined,
                                                     const LandmarkTable& map);

/// A table, one line per finding, with a heading.
[[nodiscard]] std::vector<std::string> findingsTable(const std::vector<CalibrationFinding>& findings);
}  // namespace mrpt_ext
