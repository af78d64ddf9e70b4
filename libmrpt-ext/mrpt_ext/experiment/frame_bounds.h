#pragma once

#include <optional>

#include "mrpt_ext/frames/frame_synchronizer.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Cramer-Rao bound of frames that are solved one by one.
struct FrameBound
{
  std::size_t frames = 0;      ///< that determine a pose
  double position_rmse = 0;    ///< [m] root of the mean of the frames' C_xx + C_yy
  double position_median = 0;  ///< [m] median of the roots
  double heading_rmse_deg = 0;
};

enum class BoundOf
{
  bearings,   ///< identified bearings alone, three landmarks or more
  everything  ///< identified bearings and ranges
};

/// The bound at the true poses, with the configured standard deviations. Nothing when no frame with a true pose
/// determines one. Where the truth has no heading, zero stands for it: the position bound does not depend on the
/// heading, exactly so for sensors in the centre of the robot.
[[nodiscard]] std::optional<FrameBound> boundOfFrames(const FrameStream& frames, const LandmarkTable& map,
                                                      const Trajectory& truth, BoundOf what);
}  // namespace mrpt_ext
