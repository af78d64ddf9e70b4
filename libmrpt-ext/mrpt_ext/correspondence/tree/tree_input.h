#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"

namespace mrpt_ext
{
/// What an interpretation tree is asked: the bearings that were taken from one place.
struct TreeQuestion
{
  const SensorPlace* place = nullptr;
  std::vector<UnidentifiedBearing> bearings;
  double std_bearing = 0;  ///< of the worst [rad]
};

/// The place with most bearings that may show a landmark, of several the last. It points to one of `places`.
[[nodiscard]] TreeQuestion askFullestPlace(const LandmarkIndex& map, std::span<const SensorPlace> places);

/// Gate, area, range and budget as the search has them.
[[nodiscard]] InterpretationOptions treeOptions(const TreeQuestion& question, const PoseSearchOptions& options);

/// The pose of a sensor as the pose of its robot.
[[nodiscard]] GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor);
}  // namespace mrpt_ext
