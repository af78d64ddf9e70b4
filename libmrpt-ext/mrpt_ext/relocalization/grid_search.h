#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// A bearing without a name, taken from a place that is rigidly joined to the pose asked for.
struct WindowBearing
{
  Pose2 T_robot_sensor;     ///< where it was taken from, in the axes of that pose
  double bearing = 0;       ///< [rad, CCW from the sensor's forward axis]
  double std_bearing = 0;   ///< with what joins the places [rad]
  int kind = kAnyCategory;  ///< of landmark (scan.h)
};

struct GridSearchOptions
{
  double cell = 0.3;            ///< side of a cell [m]
  double turn = degToRad(3.0);  ///< its heading [rad]
  double gate = 3;              ///< standard deviations at which a bearing counts as false
  std::size_t max_poses = 400;  ///< returned
  double max_work = 4e8;        ///< bearings x landmarks x cells: above, the map is too large for a grid
};

/// Every pose of a region tried: the cells whose poses explain bearings better than all their neighbours do, best
/// first, each with the spread of its cell. A bearing counts by its distance to the nearest landmark that it may show,
/// in standard deviations of bearing and cell together. Any number of bearings, in any directions, however the
/// landmarks stand: what closed forms over minimal sets of bearings need is not needed here. Empty without bearings and
/// where the work would exceed `max_work`.
[[nodiscard]] std::vector<GaussianPose> gridMaxima(std::span<const WindowBearing> bearings, const LandmarkIndex& map,
                                                   const PoseRegion& region, const GridSearchOptions& options = {});
}  // namespace mrpt_ext
