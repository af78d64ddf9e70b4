#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"

namespace mrpt_ext
{
/// What an interpretation tree is asked: the bearings that were taken from one place.
struct TreeInput
{
  const Scan* place = nullptr;
  std::vector<AnonymousBearing> bearings;
  double std_bearing = 0;  ///< of the worst [rad]
};

/// The place with most bearings that may show a landmark, of several the last. It points to one of `places`.
[[nodiscard]] TreeInput scanWithMostBearings(const LandmarkIndex& map, std::span<const Scan> places);

/// Gate, area, range and budget as the search has them.
[[nodiscard]] InterpretationOptions treeOptions(const TreeInput& question, const PoseSearchOptions& options);

/// The pose of a sensor as the pose of its robot.
[[nodiscard]] GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor);
}  // namespace mrpt_ext
