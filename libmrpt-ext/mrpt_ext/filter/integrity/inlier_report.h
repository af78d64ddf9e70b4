#pragma once

#include <string>
#include <vector>

namespace mrpt_ext
{
/// Inliers among the detections of one reading, under the posterior. Detections that no landmark of the map can have
/// caused are not counted.
struct SensorInliers
{
  std::string sensor;             ///< sensorKey()
  double inliers = 0;             ///< expected number under the posterior
  double expected = 0;            ///< under the learned clutter probabilities
  double expected_by_sensor = 0;  ///< under the clutter probability that the sensor declares
  std::size_t detections = 0;
};

/// Of one frame, one entry per reading; from ObservationModel::countInliers().
using InlierReport = std::vector<SensorInliers>;
}  // namespace mrpt_ext
