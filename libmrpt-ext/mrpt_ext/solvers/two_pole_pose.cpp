#include "mrpt_ext/solvers/two_pole_pose.h"

#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
TwoPolePose solveTwoPolePose(const Vector2d& p, const Vector2d& q, const PoleField& field)
{
  TwoPolePose result;
  if (!p.allFinite() || !q.allFinite() || !std::isfinite(field.depth)) return result;
  if (!(field.half_width > 0) || !std::isfinite(field.half_width)) return result;
  const Vector2d p_to_q = q - p;
  result.status = SolveStatus::degenerate;
  if (p_to_q.norm() <= 1e-12 * field.half_width) return result;

  result.status = SolveStatus::ok;
  result.beta = -angleOf(p_to_q);  // atan2(y_p - y_q, x_q - x_p): the poles lie parallel to the world's x axis
  const Matrix2d turned_from_world = rotation(-result.beta), world_from_turned = rotation(result.beta);
  result.turned_q = turned_from_world * Vector2d(field.half_width, field.depth) - q;
  result.turned_p = turned_from_world * Vector2d(-field.half_width, field.depth) - p;
  result.world_q = world_from_turned * result.turned_q;
  result.world_p = world_from_turned * result.turned_p;
  result.world_mean = 0.5 * (result.world_q + result.world_p);
  result.misfit = p_to_q.norm() - 2 * field.half_width;
  return result;
}

Pose2 robotPose(const TwoPolePose& pose)
{
  return {pose.world_mean.x(), pose.world_mean.y(), headingFromSlope(pose.beta)};
}
}  // namespace mrpt_ext
