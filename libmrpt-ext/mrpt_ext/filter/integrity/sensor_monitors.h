#pragma once

#include <map>
#include <string>

#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// "camera bearings", "stereo ranges and bearings": what one sensor measures is one kind.
[[nodiscard]] std::string sensorKey(const Reading& reading);

/// Agreement of each kind of measurement with the posterior, over a short and over a long time.
///
/// One average over all detections is ruled by the sensor that speaks most often: a camera that contradicts the place
/// once a second is not heard beside a radio that agrees twenty times. A kind raises the alarm when it agrees much less
/// than it used to (w_fast against w_slow of augmented Monte Carlo localization: Thrun, Burgard, Fox, Probabilistic
/// Robotics, 8.3.5); one that never agreed has another fault and is only named.
class SensorMonitors
{
 public:
  explicit SensorMonitors(const RecoveryOptions& options) : options_(options) {}

  /// As InlierRatioMonitor::observe(), of detections of one kind.
  void observe(const std::string& kind, double explained_share, double expected_share, std::size_t detections);
  /// Some kind agrees no longer.
  [[nodiscard]] bool dropped() const;
  /// "camera bearings explain only 12 % of what is expected": the worst kind below what is suspicious; else empty.
  [[nodiscard]] std::string finding() const;

 private:
  struct Averages
  {
    InlierRatioMonitor quick, slow;
  };
  RecoveryOptions options_;
  std::map<std::string, Averages> kinds_;
};
}  // namespace mrpt_ext
