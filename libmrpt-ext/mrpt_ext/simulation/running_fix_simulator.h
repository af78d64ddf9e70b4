#pragma once

#include <optional>

#include "mrpt_ext/simulation/odometry_simulator.h"
#include "mrpt_ext/simulation/sensor_simulator.h"

namespace mrpt_ext
{
/// A sensor that measures a landmark's range, lets the robot move on by `fix_distance` and measures it again
/// (paper 004). It watches one landmark at a time: the nearest when it begins; when that one gets out of view it begins
/// anew. Every range is used in one fix only, and is not logged on its own.
class RunningFixSimulator
{
 public:
  RunningFixSimulator(const SimulatedSensor& sensor, const RobotPath& path, const SimulatedOdometry& odometry,
                      RandomStream random);

  /// What the sensor sees at `time` [s] from the true pose `robot`; a fix when this is a second range.
  [[nodiscard]] std::optional<RunningFixReading> look(double time, const Pose2& robot,
                                                      const std::vector<SceneFeature>& features);

 private:
  struct First
  {
    double time = 0;
    std::size_t feature = 0;
    MeasuredRange measured;
  };
  void begin(double time, const std::vector<VisibleFeature>& sightings);
  [[nodiscard]] std::optional<RunningFixReading> finish(double time, const VisibleFeature& sighting,
                                                        const std::vector<SceneFeature>& features);

  SimulatedSensor sensor_;
  const RobotPath& path_;
  const SimulatedOdometry& odometry_;
  RandomStream random_;
  std::optional<First> first_;
};
}  // namespace mrpt_ext
