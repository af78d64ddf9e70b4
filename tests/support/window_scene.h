#pragma once

#include <vector>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/local_map/past_scan.h"
#include "trajectory_scene.h"

namespace mrpt_ext
{
/// A window of scans along a short trajectory.
struct WindowSceneOptions
{
  SearchSceneOptions scene;
  double length = 2;                     ///< of the trajectory [m]
  double step = 0.25;                    ///< [m] between two scans
  double turn = degToRad(10);            ///< [rad/m]
  double std_xy_per_m = 0.02;            ///< odometry, after one metre [m]; variances are proportional to the distance
  double std_phi_per_m = degToRad(1.0);  ///< likewise [rad]
};

struct WindowScene
{
  std::vector<PastScan> scans;          ///< oldest first
  std::vector<std::vector<int>> truth;  ///< landmark of each detection of each scan; -1: false
  Pose2 robot;                          ///< at the end
};

/// A trajectory that ends at `end`.
inline WindowScene driveTo(const SceneMap& map, const LandmarkIndex& index, const WindowSceneOptions& options,
                           const Pose2& end, RandomStream& random)
{
  const int steps = static_cast<int>(std::lround(options.length / options.step));
  const double grown = std::sqrt(options.step);
  const Vector3d std(options.std_xy_per_m * grown, options.std_xy_per_m * grown, options.std_phi_per_m * grown);
  const DrivenTrajectory trajectory =
      driveSteps(end, {options.step, 0, options.turn * options.step}, steps, std, random);
  WindowScene view;
  view.robot = end;
  for (std::size_t k = 0; k < trajectory.poses.size(); ++k)
  {
    SceneScan observed = observe(map, index, options.scene, trajectory.true_poses[k], random);
    observed.scan.T_robot_sensor = trajectory.poses[k];
    view.scans.push_back({std::move(observed.scan), trajectory.covariances[k]});
    view.truth.push_back(std::move(observed.truth));
  }
  return view;
}

inline WindowScene driveSomewhere(const SceneMap& map, const LandmarkIndex& index, const WindowSceneOptions& options,
                                  RandomStream& random)
{
  const double border = std::min(options.scene.border, 0.45 * map.side);
  const double x = random.uniform(border, map.side - border), y = random.uniform(border, map.side - border);
  return driveTo(map, index, options, {x, y, random.uniform(-kPi, kPi)}, random);
}
}  // namespace mrpt_ext
