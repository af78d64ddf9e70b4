#include "mrpt_ext/vision/tags/tag_pose.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <optional>

#include "mrpt_ext/vision/tags/tag_fit.h"

namespace mrpt_ext
{
namespace
{
using Vector8 = Eigen::Matrix<double, 8, 1>;

constexpr double kSamePose = 1e-3;  ///< [rad] between two descents that ended in one minimum

/// From the homography of the corners' rays; nothing when they enclose no area or are not convex.
std::optional<RigidPose> poseByHomography(const TagSight& sight)
{
  Eigen::Matrix<double, 8, 8> equations = Eigen::Matrix<double, 8, 8>::Zero();
  Vector8 right_side;
  for (int i = 0; i < 4; ++i)
  {
    const auto ray = sight.camera.rayOf(sight.corners[i]);
    if (!ray) return std::nullopt;
    const Eigen::RowVector3d at(kSquare[i].x(), kSquare[i].y(), 1);
    for (int axis = 0; axis < 2; ++axis)
    {
      equations.block<1, 3>(2 * i + axis, 3 * axis) = at;
      equations.block<1, 2>(2 * i + axis, 6) = -(*ray)[axis] * at.head<2>();
      right_side[2 * i + axis] = (*ray)[axis];
    }
  }
  const Eigen::FullPivLU<Eigen::Matrix<double, 8, 8>> lu(equations);
  if (!lu.isInvertible()) return std::nullopt;
  const Vector8 h = lu.solve(right_side);
  for (const Eigen::Vector2d& corner : kSquare)
    if (!(1 + h.tail<2>().dot(corner) > 0)) return std::nullopt;
  const Eigen::Vector3d x(h[0], h[3], h[6]), y(h[1], h[4], h[7]);
  const double scale = 0.5 * (x.norm() + y.norm());
  if (!(scale > 0)) return std::nullopt;
  Eigen::Matrix3d axes;
  axes << x.normalized(), y.normalized(), x.cross(y).normalized();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return RigidPose{svd.matrixU() * svd.matrixV().transpose(),
                   0.5 * sight.edge / scale * Eigen::Vector3d(h[2], h[5], 1)};
}

/// The same silhouette under a perspective without depth: the tag's normal mirrored at the line of sight.
RigidPose mirrored(const TagPose& pose)
{
  const Eigen::Vector3d sight = pose.centre.normalized();
  const Eigen::Matrix3d about_sight = 2 * sight * sight.transpose() - Eigen::Matrix3d::Identity();
  return {about_sight * pose.rotation * Eigen::Vector3d(-1, -1, 1).asDiagonal(), pose.centre};
}
}  // namespace

std::vector<TagPose> posesOfTag(const TagCorners& corners, double edge, const PinholeCamera& camera,
                                const TagNoise& noise)
{
  const TagSight sight(corners, edge, camera, noise);
  std::vector<TagPose> poses;
  const auto start = poseByHomography(sight);
  if (!start) return poses;
  if (const auto first = descended(*start, sight)) poses.push_back(*first);
  if (poses.empty()) return poses;
  const auto second = descended(mirrored(poses.front()), sight);
  if (!second || (second->rotation - poses.front().rotation).norm() < kSamePose) return poses;
  poses.push_back(*second);
  if (poses[1].residual < poses[0].residual) std::swap(poses[0], poses[1]);
  return poses;
}
}  // namespace mrpt_ext
