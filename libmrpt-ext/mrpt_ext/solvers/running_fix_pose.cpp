#include "mrpt_ext/solvers/running_fix_pose.h"

#include <algorithm>

#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
/// The reading turned into world axes.
struct TurnedFix
{
  RangePair ranges;  ///< of the sensor; the displacement covariance holds odometry noise alone
  Vector2d offset;   ///< sensor from the robot centre at the second range, world axes
  Vector2d d_shift;  ///< d displacement / d heading
};

TurnedFix turn(const RunningFixReading& fix, const Vector2d& landmark, double heading)
{
  const Pose2& d = fix.displacement;
  const Vector2d m = fix.T_robot_sensor.position();
  const Matrix2d R1 = rotation(heading - d.phi);  // axes of the first pose, in which the displacement was logged
  // Sensor displacement: robot displacement plus what the turn does to the offset.
  const Vector2d in_first = d.position() + rotation(d.phi) * m - m;
  Eigen::Matrix<double, 2, 3> J;  // d sensor displacement (world axes) / d (x, y, phi); the second heading is fixed,
  J.leftCols<2>() = R1;           // so a turn error turns the first pose back
  J.col(2) = -perpendicular(R1 * (d.position() - m));
  TurnedFix turned;
  turned.ranges = {landmark,
                   R1 * in_first,
                   fix.first_range,
                   fix.second_range,
                   fix.first_std,
                   fix.second_std,
                   J * fix.displacement_covariance * J.transpose()};
  turned.offset = rotation(heading) * m;
  turned.d_shift = perpendicular(R1 * in_first);
  return turned;
}

/// d (second position) / d heading: both ranges are kept while the displacement turns.
Vector2d positionShift(const TurnedFix& turned, const RunningFixCandidate& candidate)
{
  const Vector2d u1 = (candidate.first - turned.ranges.landmark).normalized();
  const Vector2d u2 = (candidate.second.mean - turned.ranges.landmark).normalized();
  // u2 . s = 0 and u1 . (s - d_shift) = 0
  const double sine = cross(u1, u2);
  if (!candidate.linearised || std::abs(sine) < 1e-9) return Vector2d::Zero();
  return -perpendicular(u2) * (u1.dot(turned.d_shift) / sine);
}

double bearingLogDensity(const RunningFixReading& fix, const Vector2d& landmark, const GaussianPose& pose)
{
  if (!fix.second_bearing || !(fix.second_bearing_std > 0)) return 0;
  const JacobianRow J = bearingJacobian(pose.mean, landmark, fix.T_robot_sensor.position());
  const double variance = square(fix.second_bearing_std) + J * pose.covariance * J.transpose();
  const double innovation = wrap(*fix.second_bearing - predictBearing(pose.mean, landmark, fix.T_robot_sensor));
  return logNormal(innovation, variance);
}
}  // namespace

RunningFixPoses runningFixPoses(const RunningFixReading& fix, const Vector2d& landmark, const HeadingPrior& heading)
{
  RunningFixPoses result;
  const bool usable = std::isfinite(heading.heading) && heading.std_heading > 0 && std::isfinite(heading.std_heading) &&
                      isFinite(fix.displacement) && isFinite(fix.T_robot_sensor);
  if (!usable) return result;
  const TurnedFix turned = turn(fix, landmark, heading.heading);
  const RunningFix fixes = runningFix(turned.ranges);
  result.status = fixes.status;
  result.relation = fixes.relation;
  for (const RunningFixCandidate& position : fixes.candidates)
  {
    const Vector2d robot = position.second.mean - turned.offset;
    const Vector2d d_robot = positionShift(turned, position) - perpendicular(turned.offset);
    RunningFixPose candidate;
    candidate.pose.mean = {robot.x(), robot.y(), wrap(heading.heading)};
    candidate.pose.covariance = withHeading(position.second.covariance, d_robot, square(heading.std_heading));
    candidate.from_gap = !fixes.intersects;
    candidate.log_score = bearingLogDensity(fix, landmark, candidate.pose);
    result.candidates.push_back(candidate);
  }
  std::stable_sort(result.candidates.begin(), result.candidates.end(),
                   [](const RunningFixPose& a, const RunningFixPose& b) { return a.log_score > b.log_score; });
  return result;
}
}  // namespace mrpt_ext
