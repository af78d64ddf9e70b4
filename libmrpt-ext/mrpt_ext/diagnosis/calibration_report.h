#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/diagnosis/calibration_data.h"
#include "mrpt_ext/diagnosis/calibration_finding.h"

namespace mrpt_ext
{
/// The errors that were found on top of the configured corrections, as values of the configuration. Where [Bias] or
/// [Sensor_<label>] states the mean of an estimated error, that mean is reported. Only the difference of two clocks is
/// observable: it is attributed to odometry where that is commanded, or the configuration does so, and there is one
/// sensor; else to the sensor. A value differs when it is more than three standard deviations from the configured one;
/// what is only told together (offset and scale of a range, distances of all motions and of arcs) is set together.
/// Offsets of the landmarks are one finding: their root mean square.
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
