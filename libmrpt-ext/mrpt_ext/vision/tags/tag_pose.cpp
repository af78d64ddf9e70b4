#include "mrpt_ext/vision/tags/tag_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <optional>

namespace mrpt_ext
{
namespace
{
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector8 = Eigen::Matrix<double, 8, 1>;
using Vector10 = Eigen::Matrix<double, 10, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kDescentSteps = 40;
constexpr double kDescended = 1e-10;      ///< share of the residual that a step still takes off
constexpr double kFirstDamping = 1e-3;    ///< Levenberg and Marquardt
constexpr double kLargestDamping = 1e10;  ///< at which nothing descends any more
constexpr double kSamePose = 1e-3;        ///< [rad] between two descents that ended in one minimum

/// Corners of a square with an edge of 2, in the order of TagCorners.
const std::array<Eigen::Vector2d, 4> kSquare{Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1), Eigen::Vector2d(1, -1),
                                             Eigen::Vector2d(-1, -1)};

struct RigidPose
{
  Eigen::Matrix3d rotation;
  Eigen::Vector3d centre;
};

/// What is seen of a tag, and of which size it is.
struct TagSight
{
  const TagCorners& corners;
  double edge;
  const PinholeCamera& camera;
  TagNoise noise;
  Eigen::Matrix<double, 2, 3> level;  ///< horizontal part of what is given in camera axes
};

/// Distances of the corners in the image and of the upright edges from the vertical, in standard deviations; with their
/// derivative by a rotation about the centre and a shift, negative.
struct TagMisfit
{
  Vector10 distances;
  Eigen::Matrix<double, 10, 6> by_pose = Eigen::Matrix<double, 10, 6>::Zero();
};

/// Derivative of a vector by a rotation.
Eigen::Matrix3d byRotation(const Eigen::Vector3d& v)
{
  Eigen::Matrix3d derivative;
  derivative << 0, v.z(), -v.y(), -v.z(), 0, v.x(), v.y(), -v.x(), 0;
  return derivative;
}

std::optional<TagMisfit> misfitOf(const RigidPose& pose, const TagSight& sight)
{
  TagMisfit misfit;
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::Vector3d arm = 0.5 * sight.edge * (pose.rotation.leftCols<2>() * kSquare[i]);
    const auto seen = sight.camera.project(pose.centre + arm);
    if (!seen) return std::nullopt;
    misfit.distances.segment<2>(2 * i) = (sight.corners[i] - seen->pixel) / sight.noise.std_corner;
    misfit.by_pose.block<2, 3>(2 * i, 0) = seen->by_point * byRotation(arm) / sight.noise.std_corner;
    misfit.by_pose.block<2, 3>(2 * i, 3) = seen->by_point / sight.noise.std_corner;
  }
  // Those edges are upright that are less horizontal.
  const Eigen::Vector3d x = pose.rotation.col(0), y = pose.rotation.col(1);
  const Eigen::Vector3d upright = (sight.level * x).squaredNorm() < (sight.level * y).squaredNorm() ? x : y;
  misfit.distances.tail<2>() = -sight.level * upright / sight.noise.std_upright;
  misfit.by_pose.block<2, 3>(8, 0) = sight.level * byRotation(upright) / sight.noise.std_upright;
  return misfit;
}

RigidPose moved(const RigidPose& pose, const Vector6& step)
{
  const double angle = step.head<3>().norm();
  const Eigen::Vector3d axis = angle > 0 ? Eigen::Vector3d(step.head<3>() / angle) : Eigen::Vector3d::UnitX();
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix() * pose.rotation, pose.centre + step.tail<3>()};
}

/// From a pose into the minimum that it lies above; nothing where the corners do not determine a pose.
std::optional<TagPose> descended(RigidPose pose, const TagSight& sight)
{
  auto misfit = misfitOf(pose, sight);
  if (!misfit) return std::nullopt;
  double residual = misfit->distances.squaredNorm(), damping = kFirstDamping;
  for (int step = 0; step < kDescentSteps && damping < kLargestDamping; ++step)
  {
    Matrix6 normal = misfit->by_pose.transpose() * misfit->by_pose;
    normal.diagonal() *= 1 + damping;
    const RigidPose next = moved(pose, normal.ldlt().solve(misfit->by_pose.transpose() * misfit->distances));
    auto there = misfitOf(next, sight);
    if (!there || !(there->distances.squaredNorm() < residual))
    {
      damping *= 10;
      continue;
    }
    const double gain = residual - there->distances.squaredNorm();
    pose = next, misfit = std::move(there), damping *= 0.1, residual -= gain;
    if (gain < kDescended * residual) break;
  }
  const Eigen::FullPivLU<Matrix6> normal(misfit->by_pose.transpose() * misfit->by_pose);
  if (!normal.isInvertible()) return std::nullopt;
  return TagPose{pose.rotation, pose.centre, normal.inverse().bottomRightCorner<3, 3>(), residual};
}

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
  const TagSight sight{corners, edge, camera, noise, camera.levelAxes().topRows<2>()};
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
