#include "mrpt_ext/solvers/camera_yaw_calibration.h"

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
CameraYaw calibrateCameraYaw(std::span<const CalibrationSighting> sightings, const Pose2& T_robot_camera)
{
  CameraYaw result;
  if (sightings.empty()) return result;
  const auto difference = [&](const CalibrationSighting& s)
  { return wrap(s.bearing - predictBearing(s.robot, s.landmark, T_robot_camera)); };

  Vector2d sum = Vector2d::Zero();
  for (const CalibrationSighting& s : sightings) sum += direction(difference(s));
  const double count = static_cast<double>(sightings.size());
  result.status = SolveStatus::bad_input;
  if (!sum.allFinite()) return result;
  result.status = SolveStatus::none;
  if (sum.norm() < 0.5 * count) return result;

  result.status = SolveStatus::ok;
  result.offset = angleOf(sum);
  double squares = 0;
  for (const CalibrationSighting& s : sightings) squares += square(wrap(difference(s) - result.offset));
  if (sightings.size() > 1) result.scatter = std::sqrt(squares / (count - 1));
  result.std_offset = result.scatter / std::sqrt(count);
  return result;
}
}  // namespace mrpt_ext
