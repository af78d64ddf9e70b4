#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/pose_search_result.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"

namespace mrpt_ext
{
/// Input of an interpretation tree: the bearings of one scan.
struct TreeInput
{
  const Scan* scan = nullptr;
  std::vector<AnonymousBearing> bearings;
  double std_bearing = 0;  ///< of the worst [rad]
};

/// The scan with most bearings that may show a landmark, of several the last. The result points into `scans`.
[[nodiscard]] TreeInput scanWithMostBearings(const LandmarkIndex& map, std::span<const Scan> scans);

/// Gate, area, range and budget for a pose search.
[[nodiscard]] InterpretationOptions treeOptions(const TreeInput& input, const PoseSearchOptions& options);

/// Pose of the robot from the pose of its sensor.
[[nodiscard]] GaussianPose robotPose(const GaussianPose& sensor, const Pose2& T_robot_sensor);
}  // namespace mrpt_ext
