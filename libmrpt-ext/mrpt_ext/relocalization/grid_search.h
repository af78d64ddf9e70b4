#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/work_budget.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// An anonymous bearing of a window, with the sensor pose relative to the robot pose that is searched for.
struct WindowBearing
{
  Pose2 T_robot_sensor;         ///< in the robot frame at that pose
  double bearing = 0;           ///< [rad, CCW from the sensor's forward axis]
  double std_bearing = 0;       ///< odometry within the window included [rad]
  int category = kAnyCategory;  ///< of landmark (scan.h)
};

inline constexpr double kGridCell = 0.3;             ///< side of a cell [m]
inline constexpr double kGridTurn = degToRad(3.0);   ///< its heading interval [rad]
inline constexpr std::size_t kMostGridMaxima = 400;  ///< returned by gridMaxima()

/// Exhaustive search of a region: the robust likelihood of the bearings at the centre of every cell; returns the local
/// maxima, best first, each with the spread of its cell as covariance. A bearing contributes its squared distance, in
/// standard deviations of bearing and cell together, to the nearest landmark of its category, truncated at the gate.
/// Unlike closed forms over minimal subsets, it works for any number of bearings in any geometry. Empty without
/// bearings, and if the region is too large (bearings x landmarks x cells beyond 4e8, or beyond `budget`).
[[nodiscard]] std::vector<GaussianPose> gridMaxima(std::span<const WindowBearing> bearings, const LandmarkIndex& map,
                                                   const PoseRegion& region, WorkBudget& budget);
}  // namespace mrpt_ext
