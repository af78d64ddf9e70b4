#pragma once

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
  ObjectTracker(const std::vector<Frame>& sightings, const OdometryPath& odometry)
      : sightings_(sightings), odometry_(odometry)
  {
  }

  /// Places everything seen up to the time of `robot` that has not been placed yet, from that pose moved back by
  /// odometry to the time of the sighting.
  void place(const TrackPoint& robot, std::vector<ObjectRow>& rows);

 private:
  const std::vector<Frame>& sightings_;
  const OdometryPath& odometry_;
  std::size_t next_ = 0;
};
}  // namespace mrpt_ext
