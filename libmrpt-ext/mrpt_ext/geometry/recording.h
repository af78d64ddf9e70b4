#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/range_scan.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Dead-reckoned robot pose; only differences of consecutive records mean something.
struct OdometryRecord
{
  double time = 0;  ///< [s]
  Pose2 pose;       ///< accumulated from body-frame increments
};

/// Absolute heading from a compass or an attitude sensor.
struct CompassRecord
{
  double time = 0;  ///< [s]
  std::string sensor;
  double heading = 0;      ///< [rad] in the map frame
  double std_heading = 0;  ///< [rad]
};

/// One entry of a log. A Reading in a recording has its sensor pose in the robot frame at its own time.
using Record = std::variant<OdometryRecord, Reading, RunningFixReading, CompassRecord, RangeScan>;

[[nodiscard]] inline double timeOf(const Record& record)
{
  return std::visit([](const auto& r) { return r.time; }, record);
}

/// What importers and the simulator produce: a log, with the map and the truth that go with it.
struct Recording
{
  std::vector<Record> records;  ///< ordered by time
  LandmarkTable map;
  Trajectory truth;                ///< may be empty
  std::vector<std::string> notes;  ///< what was dropped, corrected or counted on import, one line each
};
}  // namespace mrpt_ext
