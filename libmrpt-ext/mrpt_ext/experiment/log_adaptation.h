#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/experiment/bearing_extent.h"
#include "mrpt_ext/experiment/detection_reach.h"
#include "mrpt_ext/experiment/method_factory.h"

namespace mrpt_ext
{
/// What a log contains.
struct LogContents
{
  const AvailableMeasurements& available;
  const DetectionReach& reach;
  const BearingExtent& extent;
  double duration = 0;  ///< [s]
};

/// Adapts the configuration to what the log contains, and adds a line to `notes` for each adaptation:
/// - The box of possible positions, where none is configured, is as large as the detections reach (detection_reach.h).
/// - Where detections are anonymous, the field of view of a sensor that declares none holds its bearings
///   (bearing_extent.h), unless `auto_calibrate` is off: then a run is what it would be live, where nobody knows the
///   whole log. Identified detections do not need it.
/// - Without odometry, a motion model of type `odometry` or `velocity` has nothing to work on: the motion is a random
///   walk at walking speed.
/// - Where moreover the measurements hardly depend on the heading (ranges to the robot's origin or near it), the
/// heading
///   is unobservable: the filters estimate and judge the position alone. "Hardly": between the random walk of the
///   heading and the information per second, its stationary standard deviation is larger than `ok` allows.
void adaptToLog(LocalizationConfig& config, const LogContents& log, std::vector<std::string>& notes);

/// Standard deviation [rad] at which a random walk of variance `walk` [rad^2/s] is held by measurements with
/// `information` [1/(rad^2 s)]: the stationary solution of the Riccati equation, (walk / information)^(1/4).
[[nodiscard]] double stationaryStd(double walk, double information);
}  // namespace mrpt_ext
