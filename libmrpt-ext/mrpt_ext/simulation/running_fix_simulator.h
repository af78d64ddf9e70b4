#pragma once

#include <optional>

#include "mrpt_ext/simulation/odometry_simulator.h"
#include "mrpt_ext/simulation/sensor_simulator.h"

namespace mrpt_ext
{
/// A sensor that measures the range to a landmark, and again after the robot has moved by `fix_distance` (paper 004).
/// One landmark at a time: the nearest at the first range; when it leaves the view the sensor starts over. Every range
/// belongs to one fix only, and is not logged on its own.
class RunningFixSimulator
{
 public:
  RunningFixSimulator(const SimulatedSensor& sensor, const RobotPath& path, const SimulatedOdometry& odometry,
                      RandomStream random);

  /// Measures at `time` [s] from the true pose `robot`; returns a fix at every second range.
  [[nodiscard]] std::optional<RunningFixReading> measure(double time, const Pose2& robot,
                                                         const std::vector<SceneFeature>& features);

 private:
  struct First
  {
    double time = 0;
    std::size_t feature = 0;
    MeasuredRange measured;
  };
  void begin(double time, const std::vector<VisibleFeature>& visible);
  [[nodiscard]] std::optional<RunningFixReading> finish(double time, const VisibleFeature& feature,
                                                        const std::vector<SceneFeature>& features);

  SimulatedSensor sensor_;
  const RobotPath& path_;
  const SimulatedOdometry& odometry_;
  RandomStream random_;
  std::optional<First> first_;
};
}  // namespace mrpt_ext
