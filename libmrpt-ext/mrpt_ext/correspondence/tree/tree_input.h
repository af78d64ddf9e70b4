#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"

namespace mrpt_ext
{
/// What an interpretation tree is asked: the bearings that were taken from one scan.
struct TreeInput
{
  const Scan* scan = nullptr;
  std::vector<AnonymousBearing> bearings;
  double std_bearing = 0;  ///< of the worst [rad]
};

/// The scan with most bearings that may show a landmark, of several the last. It points to one of `scans`.
[[nodiscard]] TreeInput scanWithMostBearings(const LandmarkIndex& map, std::span<const Scan> scans);

/// Gate, area, range and budget as the search has them.
[[nodiscard]] InterpretationOptions treeOptions(const TreeInput& input, const PoseSearchOptions& options);

/// The pose of a sensor as the pose of its robot.
[[nodiscard]] GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor);
}  // namespace mrpt_ext
