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
/// A value of the configuration beside its estimate from the log.
struct CalibrationFinding
{
  std::string what;  ///< "camera: bearings too large by"
  std::string unit;  ///< of the three numbers, as in the .ini
  double configured = 0;
  double estimate = 0;  ///< from the log
  double std = 0;       ///< of the estimate
  int decimals = 3;
  bool is_flag = false;            ///< values are 0: no, or 1: yes
  std::string why_not_observable;  ///< empty: observable
  IniAssignment line;              ///< that sets the estimate
  bool differs = false;            ///< significantly: the line should be set
  std::string remark;              ///< in place of the line: what no line can set
};

/// The errors that were found on top of the configured corrections, as values of the configuration. Where [Bias] or
/// [Sensor_<label>] states the mean of an estimated error, that mean is reported. Only the difference of two clocks is
/// observable: it is attributed to odometry where that is commanded, or the configuration does so, and there is one
/// sensor; else to the sensor. A value differs when it is more than three standard deviations from the configured one;
/// offset and scale of a range are set together. Offsets of the landmarks are one finding: their root mean square.
[[nodiscard]] std::vector<CalibrationFinding> calibrationFindings(const CalibrationResult& errors,
                                                                  const CalibrationData& data,
                                                                  const LocalizationConfig& config);

/// Whether ranges are depths, for the sensors for which this is a question.
[[nodiscard]] std::vector<CalibrationFinding> depthFindings(const CalibrationData& data);

/// Completes the line that sets the estimate; `differs`: it should be set, where the log determines it.
void settleLine(CalibrationFinding& found, bool differs);

/// "58 bearings and ranges", "58 ranges": both together.
[[nodiscard]] std::string readingsText(std::size_t bearings, std::size_t ranges);

/// Shares of outliers by landmark, one line each.
[[nodiscard]] std::vector<std::string> landmarkLines(const CalibrationResult& errors, const CalibrationData& data,
                                                     const LandmarkTable& map);

/// A table, one line per finding, with a heading.
[[nodiscard]] std::vector<std::string> findingsTable(const std::vector<CalibrationFinding>& findings);
}  // namespace mrpt_ext
