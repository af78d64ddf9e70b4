#pragma once

#include <deque>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// Positions of detected objects that are not landmarks (paper 001's ball): from range and bearing, or from bearings of
/// two sensors (triangulation), transformed into the map by the filter's pose.
class ObjectTracker
{
 public:
  explicit ObjectTracker(const OdometryPath& odometry) : odometry_(odometry) {}

  /// Detections of objects, ordered by time.
  void add(std::vector<Frame> frames);
  /// Locates all pending objects up to the time of `robot`, from that pose moved back by odometry to the time of their
  /// detection.
  void locate(const PoseEstimate& robot, DiskBackedSequence<ObjectRow>& rows);

 private:
  const OdometryPath& odometry_;
  std::deque<Frame> pending_;  // not located yet
};
}  // namespace mrpt_ext
