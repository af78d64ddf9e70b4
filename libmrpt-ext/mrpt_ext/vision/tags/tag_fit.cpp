#include "mrpt_ext/vision/tags/tag_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector10 = Eigen::Matrix<double, 10, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kFirstDamping = 1e-3;    ///< Levenberg and Marquardt
constexpr double kLargestDamping = 1e10;  ///< at which nothing descends any more
constexpr double kStdOfHeldYaw = 1e-5;    ///< [rad]

/// Distances of the corners in the image and of the upright edges from the vertical, in standard deviations; with their
/// derivative by a rotation about the centre and a shift, negative.
struct TagMisfit
{
  Vector10 distances;
  Eigen::Matrix<double, 10, 6> by_pose = Eigen::Matrix<double, 10, 6>::Zero();
};

/// Sum of squares, with gradient (half, negative) and J^T J.
struct TagEquations
{
  double residual = 0;
  Vector6 gradient;
  Matrix6 normal;
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
  const Eigen::Matrix<double, 2, 3> flat = sight.level.topRows<2>();
  const Eigen::Vector3d x = pose.rotation.col(0), y = pose.rotation.col(1);
  const Eigen::Vector3d upright = (flat * x).squaredNorm() < (flat * y).squaredNorm() ? x : y;
  misfit.distances.tail<2>() = -flat * upright / sight.noise.std_upright;
  misfit.by_pose.block<2, 3>(8, 0) = flat * byRotation(upright) / sight.noise.std_upright;
  return misfit;
}

std::optional<TagEquations> equationsAt(const RigidPose& pose, const TagSight& sight, const std::optional<double>& yaw)
{
  const auto misfit = misfitOf(pose, sight);
  if (!misfit) return std::nullopt;
  TagEquations equations{misfit->distances.squaredNorm(), misfit->by_pose.transpose() * misfit->distances,
                         misfit->by_pose.transpose() * misfit->by_pose};
  if (!yaw) return equations;
  const TagNormal normal = normalOf(pose, sight);
  Vector6 row = Vector6::Zero();
  row.head<3>() = normal.by_rotation.transpose() / kStdOfHeldYaw;
  const double distance = wrap(*yaw - normal.yaw) / kStdOfHeldYaw;
  equations.residual += square(distance);
  equations.gradient += row * distance;
  equations.normal += row * row.transpose();
  return equations;
}

RigidPose moved(const RigidPose& pose, const Vector6& step)
{
  const double angle = step.head<3>().norm();
  const Eigen::Vector3d axis = angle > 0 ? Eigen::Vector3d(step.head<3>() / angle) : Eigen::Vector3d::UnitX();
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix() * pose.rotation, pose.centre + step.tail<3>()};
}
}  // namespace

TagNormal normalOf(const RigidPose& pose, const TagSight& sight)
{
  const Eigen::Vector3d z = pose.rotation.col(2), normal = z.dot(pose.centre) > 0 ? Eigen::Vector3d(-z) : z;
  const Eigen::Vector2d flat = sight.level.topRows<2>() * normal;
  const Eigen::RowVector2d across(-flat.y(), flat.x());
  return {std::atan2(flat.y(), flat.x()), across * sight.level.topRows<2>() * byRotation(normal) / flat.squaredNorm(),
          flat.norm(), -normal.dot(pose.centre.normalized())};
}

std::optional<TagPose> descended(RigidPose pose, const TagSight& sight, const DescentOfTag& how)
{
  auto here = equationsAt(pose, sight, how.yaw);
  if (!here) return std::nullopt;
  double damping = kFirstDamping;
  for (int step = 0; step < how.steps && damping < kLargestDamping; ++step)
  {
    Matrix6 normal = here->normal;
    normal.diagonal() *= 1 + damping;
    const RigidPose next = moved(pose, normal.ldlt().solve(here->gradient));
    const auto there = equationsAt(next, sight, how.yaw);
    if (!there || !(there->residual < here->residual))
    {
      damping *= 10;
      continue;
    }
    const double gain = here->residual - there->residual;
    pose = next, here = there, damping *= 0.1;
    if (gain < how.accuracy * here->residual) break;
  }
  if (how.yaw) return TagPose{pose.rotation, pose.centre, Matrix6::Zero(), here->residual};
  const Eigen::FullPivLU<Matrix6> normal(here->normal);
  if (!normal.isInvertible()) return std::nullopt;
  return TagPose{pose.rotation, pose.centre, normal.inverse(), here->residual};
}
}  // namespace mrpt_ext
