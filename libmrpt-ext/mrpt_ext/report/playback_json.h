#pragma once

#include <nlohmann/json_fwd.hpp>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Data of the playback in the order of its steps; times in seconds since the start of the log, lengths rounded to
/// millimetres, angles in radians rounded to 1e-3, `null` where a pose does not exist:
///   t: [...]                                truth, methods.<name>: [x, y, phi, x, y, phi, ...]
///   modes: [[x, y, phi, weight, cxx, cxy, cyy, ...] per step]
///   detections: [[sensor x, y, yaw on the robot, bearing, range, landmark index or -1, 1 for a fix, ...] per step]
///   objects: [[x, y, label index, ...] per step], object_labels: [...]
///   particles: {counts: [...], boxes: [low x, low y, width, height, ...], poses: base64, see packed_particles.h}
/// `record` with aligned odometry.
[[nodiscard]] nlohmann::ordered_json playbackJson(const RunContext& context, const RunRecord& record);
}  // namespace mrpt_ext
