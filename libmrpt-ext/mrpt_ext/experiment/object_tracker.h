#pragma once

#include <deque>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// Places seen things that are not landmarks (paper 001's ball) in the map: from range and bearing, or from bearings of
/// two sensors (triangulation), carried into the map by the filter's pose.
class ObjectTracker
{
 public:
  explicit ObjectTracker(const OdometryPath& odometry) : odometry_(odometry) {}

  /// Takes in what was seen, ordered by time.
  void add(std::vector<Frame> sightings);
  /// Places everything seen up to the time of `robot` that has not been placed yet, from that pose moved back by
  /// odometry to the time of the sighting.
  void place(const PoseEstimate& robot, DiskBackedSequence<ObjectRow>& rows);

 private:
  const OdometryPath& odometry_;
  std::deque<Frame> sightings_;  // not placed yet
};
}  // namespace mrpt_ext
