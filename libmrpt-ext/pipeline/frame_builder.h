#pragma once

#include <set>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_path.h"
#include "mrpt_ext/pipeline/sensor_config.h"

namespace mrpt_ext
{
struct FrameOptions
{
  double window = 0.05;      ///< [s] detections this close in time form one frame
  bool independent = false;  ///< no motion between frames
  OdometryCorrection odometry;
  SensorConfigs sensors;
  std::set<std::string> object_categories;  ///< detections of these are not landmarks
};

/// A log cut into frames.
struct FrameSequence
{
  std::vector<Frame> frames;         ///< ordered by time; readings are empty only where missed ones count
  std::vector<Frame> object_frames;  ///< sightings of objects, one per frame of the same time in `frames` or between
  OdometryPath odometry{{}, {}};
  UnusableDetections unusable;
  std::size_t detections = 0;  ///< of landmarks, used
};

/// Turns plain records into frames: the configuration of the sensors is applied, readings within the window are moved
/// to the stamp of the last one by odometry, the motion between frames is summed up.
[[nodiscard]] FrameSequence buildFrames(const std::vector<Record>& records, const LandmarkTable& map,
                                        const FrameOptions& options);
}  // namespace mrpt_ext
