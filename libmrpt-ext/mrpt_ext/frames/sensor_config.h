#pragma once

#include <map>
#include <optional>
#include <string>

#include "mrpt_ext/frames/reflector_extraction.h"
#include "mrpt_ext/geometry/identity_level.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/geometry/scan_sweep.h"

namespace mrpt_ext
{
/// A value per landmark id.
using LandmarkValues = std::map<int, double>;

/// The value of a landmark, 0 when it has none.
[[nodiscard]] double valueOf(const LandmarkValues& values, int id);

/// Configuration of one sensor label ([Sensor_<label>]); absent values: as logged.
struct SensorConfig
{
  double delay = 0;                              ///< [s]
  ScanSweep sweep;                               ///< of a spinning scanner
  std::optional<double> std_bearing, std_range;  ///< [rad], [m]
  double std_range_per_m = 0;
  std::optional<double> std_heading;                                            ///< [rad]
  double bias_bearing = 0, scale_bearing = 1, bias_range = 0, scale_range = 1;  ///< measured = scale * true + bias
  LandmarkValues landmark_bias_range;  ///< [m] on top of bias_range, by landmark
  bool range_along_axis = false;       ///< ... where true is the depth along an axis, of detections with a bearing
  double range_axis = 0;               ///< [rad] logged bearing of that axis
  std::optional<double> field_of_view, max_range;  ///< [rad], [m]
  double clutter_probability = 0.05;
  std::optional<double> detection_probability;
  Vector2d lever_arm{0, 0};                    ///< [m] true minus logged position on the robot, in robot axes
  std::optional<double> lever_arm_std;         ///< [m]
  std::optional<double> yaw_std;               ///< [rad] of the stated direction on the robot
  double delay_std = SensorModel{}.delay_std;  ///< [s]
  IdentityLevel association = IdentityLevel::known;
  std::optional<ReflectorOptions> reflectors;  ///< to extract from its laser scans; absent: scans are not used
  bool ignore = false;
};

/// By sensor label. A label without a section uses that of the label it continues after a dot (camera.4 that of
/// camera), else the defaults.
using SensorConfigs = std::map<std::string, SensorConfig>;

[[nodiscard]] const SensorConfig& configOf(const SensorConfigs& configs, const std::string& label);

/// The bearing that a sensor logs of a landmark at the true one [rad].
[[nodiscard]] double loggedBearing(double bearing, const SensorConfig& config);

/// Detections that cannot be used, by reason, e.g. "uwb: slant range shorter than the height difference".
using UnusableDetections = std::map<std::string, std::size_t>;

/// Applies the configuration to a logged reading: delay, biases, standard deviations, sensor model, identity level.
/// Detections that fit no pose are removed and counted; one whose range alone fits none keeps its bearing. Throws
/// InputError (configuration) when a standard deviation is neither logged nor configured.
[[nodiscard]] Reading configured(Reading reading, const SensorConfigs& configs, const LandmarkTable& map,
                                 UnusableDetections& unusable);
/// The reflectors in a laser scan, as such a reading; nothing when the scan cannot be used, which is counted.
[[nodiscard]] std::optional<Reading> configured(const RangeScan& scan, const SensorConfigs& configs,
                                                const LandmarkTable& map, UnusableDetections& unusable);
/// The same for a running fix, which must be identified; nothing when it cannot be used, which is counted.
[[nodiscard]] std::optional<RunningFixReading> configured(RunningFixReading fix, const SensorConfigs& configs,
                                                          const LandmarkTable& map, UnusableDetections& unusable);
[[nodiscard]] CompassRecord configured(CompassRecord compass, const SensorConfigs& configs);
}  // namespace mrpt_ext
