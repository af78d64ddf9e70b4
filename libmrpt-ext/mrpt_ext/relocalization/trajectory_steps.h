#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/relocalization/hypothesis_track.h"

namespace mrpt_ext
{
/// Frames as a trajectory for localizeOverTrajectory() (trajectory_search.h). The anonymous detections of
/// `step_duration` [s] are merged into the scans of one step, relative to the robot pose at its last frame. A landmark
/// counts once per step, and bearings correlated with earlier ones are dropped (DetectionDecorrelator): they share
/// their errors (calibration, map, wheels) and add no information.
[[nodiscard]] std::vector<TrajectoryStep> trajectorySteps(std::span<const Frame> frames, const MotionModel& motion,
                                                          const LandmarkTable& map, const LandmarkIndex& index,
                                                          double step_duration);
}  // namespace mrpt_ext
