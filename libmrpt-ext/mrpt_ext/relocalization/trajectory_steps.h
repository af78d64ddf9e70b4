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
/// Frames as steps of a way for localizeOverTrajectory (relocalization/trajectory_search.h). The unidentified
/// detections of `look_duration` [s] make one look, at the robot's place of its last frame. What an earlier frame of
/// the look has seen already is left out: it shares the errors that matter (calibration, map, wheels) and tells nothing
/// new.
[[nodiscard]] std::vector<TrajectoryStep> trajectorySteps(std::span<const Frame> frames, const MotionModel& motion,
                                                          const LandmarkTable& map, const LandmarkIndex& index,
                                                          double look_duration);
}  // namespace mrpt_ext
