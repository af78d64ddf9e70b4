#pragma once

#include <map>
#include <string>

#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// "camera bearings", "stereo ranges and bearings": a sensor and what it measures.
[[nodiscard]] std::string sensorKey(const Reading& reading);

/// Inlier ratio of every sensor, fast and slow.
///
/// One average over all detections is dominated by the sensor with the highest rate: a camera that contradicts the pose
/// once a second disappears beside a radio that agrees twenty times. A sensor raises the alarm when its ratio falls far
/// below what it used to be (w_fast against w_slow: Probabilistic Robotics, 8.3.5). One that never agreed has another
/// fault; it is reported only.
class SensorMonitors
{
 public:
  explicit SensorMonitors(const RecoveryOptions& options) : options_(options) {}

  /// As InlierRatioMonitor::observe(), of detections of the sensor with this key.
  void observe(const std::string& sensor, double inlier_ratio, double expected_ratio, std::size_t detections);
  /// The inlier ratio of some sensor has fallen.
  [[nodiscard]] bool dropped() const;
  /// "camera bearings: inlier ratio 12 % of the expected value": the worst suspicious sensor; empty without one.
  [[nodiscard]] std::string finding() const;

 private:
  struct Ratios
  {
    InlierRatioMonitor fast, slow;
  };
  RecoveryOptions options_;
  std::map<std::string, Ratios> ratios_;
};
}  // namespace mrpt_ext
