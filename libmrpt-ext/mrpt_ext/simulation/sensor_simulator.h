#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/simulation/scenario.h"

namespace mrpt_ext
{
/// A landmark, or an object at its present position. In lists landmarks come first.
struct SceneFeature
{
  int id = kNoId;
  std::string category;
  Vector3d position{0, 0, 0};
  bool is_landmark = true;
  double radius = 0;  ///< [m] it hides what is behind it; 0: nothing
};

/// A feature in view of a sensor, without errors.
struct VisibleFeature
{
  std::size_t feature = 0;  ///< index
  double bearing = 0;       ///< [rad] from the sensor's forward axis
  double range = 0;         ///< [m] slant or horizontal, as the sensor measures
};

/// The features inside field of view and range limits that none with a radius hides, in the order of the map.
[[nodiscard]] std::vector<VisibleFeature> visibleFeatures(const SimulatedSensor& sensor, const Pose2& robot,
                                                          const std::vector<SceneFeature>& features);

/// A measured range and its declared standard deviation [m].
struct MeasuredRange
{
  double range = 0;
  double std_range = 0;
};

/// Range with bias, scale and noise. Of a stereo pair: disparity = baseline focal / (range cos(bearing)) with Gaussian
/// noise, hence std = range^2 cos(bearing) std_disparity / (baseline focal); with a field of view of 170 degrees and
/// more the cosine is left out (omnidirectional stereo). Nothing when noise makes the range or the disparity negative.
[[nodiscard]] std::optional<MeasuredRange> measureRange(const SimulatedSensor& sensor, const VisibleFeature& feature,
                                                        RandomStream& random);

/// Bearing with bias and noise, rounded [rad].
[[nodiscard]] double measureBearing(const SimulatedSensor& sensor, const VisibleFeature& feature, RandomStream& random);

/// One reading of a sensor that measures bearings, ranges or both, clutter and misses included. The detections come in
/// random order, so that the order does not identify anonymous ones. Values rounded to 1e-6; `time` is left 0.
[[nodiscard]] Reading simulateReading(const SimulatedSensor& sensor, const Pose2& robot,
                                      const std::vector<SceneFeature>& features, RandomStream& random);

[[nodiscard]] CompassRecord simulateCompass(const SimulatedSensor& sensor, const Pose2& robot, RandomStream& random);

/// The model of the sensor that the log declares.
[[nodiscard]] SensorModel declaredModel(const SimulatedSensor& sensor);
}  // namespace mrpt_ext
