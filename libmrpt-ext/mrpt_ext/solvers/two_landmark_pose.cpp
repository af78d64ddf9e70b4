#include "mrpt_ext/solvers/two_landmark_pose.h"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "mrpt_ext/solvers/levenberg_marquardt.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext
{
namespace
{
/// Inverse covariance in the robot frame; a flat or zero covariance gets a floor so that it stays invertible.
std::vector<Matrix2d> pointWeights(std::span<const SeenLandmark> seen)
{
  double largest = 0;
  for (const SeenLandmark& s : seen) largest = std::max(largest, s.in_robot.covariance.trace());
  const double floor = largest > 0 ? 1e-9 * largest : 1.0;
  std::vector<Matrix2d> weights;
  for (const SeenLandmark& s : seen)
    weights.push_back((s.in_robot.covariance + floor * Matrix2d::Identity()).inverse());
  return weights;
}

/// Closed-form rigid fit with scalar weights; nothing when the points leave the heading open.
std::optional<Pose2> closedForm(std::span<const SeenLandmark> seen, const std::vector<Matrix2d>& weights)
{
  double sum = 0;
  Vector2d world = Vector2d::Zero(), robot = Vector2d::Zero();
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const double w = weights[i].trace();
    sum += w;
    world += w * seen[i].landmark;
    robot += w * seen[i].in_robot.mean;
  }
  world /= sum;
  robot /= sum;
  double along = 0, across = 0, size = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const Vector2d a = seen[i].in_robot.mean - robot, b = seen[i].landmark - world;
    const double w = weights[i].trace() / sum;
    along += w * a.dot(b);
    across += w * cross(a, b);
    size += w * (a.squaredNorm() + b.squaredNorm());
  }
  if (!(std::hypot(along, across) > 1e-12 * size)) return std::nullopt;
  const double heading = std::atan2(across, along);
  const Vector2d position = world - rotation(heading) * robot;
  return Pose2{position.x(), position.y(), heading};
}

NormalEquations<3> modelAt(std::span<const SeenLandmark> seen, const std::vector<Matrix2d>& weights, const Pose2& pose)
{
  NormalEquations<3> result;
  const Matrix2d R = rotation(pose.phi);
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    // Residual in robot axes, where the covariance is given: R^T (l - p) - v.
    const Vector2d expected = R.transpose() * (seen[i].landmark - pose.position());
    const Vector2d e = expected - seen[i].in_robot.mean;
    Eigen::Matrix<double, 2, 3> J;
    J.leftCols<2>() = -R.transpose();
    J.col(2) = -perpendicular(expected);
    result.cost += e.dot(weights[i] * e);
    result.gradient += J.transpose() * weights[i] * e;
    result.hessian += J.transpose() * weights[i] * J;
  }
  return result;
}

double largestMisfit(std::span<const SeenLandmark> seen)
{
  double largest = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = i + 1; j < seen.size(); ++j)
    {
      const double on_map = (seen[i].landmark - seen[j].landmark).norm();
      const double measured = (seen[i].in_robot.mean - seen[j].in_robot.mean).norm();
      if (on_map > 0) largest = std::max(largest, std::abs(measured - on_map) / on_map);
    }
  return largest;
}

bool isUsableSighting(const SeenLandmark& s)
{
  return s.landmark.allFinite() && s.in_robot.mean.allFinite() && s.in_robot.covariance.allFinite() &&
         s.in_robot.covariance.diagonal().minCoeff() >= 0 && s.in_robot.covariance.determinant() >= 0;
}
}  // namespace

PointPose solvePointPose(std::span<const SeenLandmark> seen)
{
  PointPose result;
  result.status = SolveStatus::bad_input;
  if (!std::all_of(seen.begin(), seen.end(), isUsableSighting)) return result;
  result.status = SolveStatus::too_few;
  if (seen.size() < 2) return result;

  const std::vector<Matrix2d> weights = pointWeights(seen);
  const std::optional<Pose2> seed = closedForm(seen, weights);
  result.status = SolveStatus::degenerate;
  if (!seed) return result;
  Pose2 pose = *seed;
  const auto model = [&](const Pose2& p) { return modelAt(seen, weights, p); };
  descend<3>(
      pose, model, [&](const Pose2& p) { return model(p).cost; },
      [](const Pose2& p, const Vector3d& step) {
        return Pose2{p.x + step.x(), p.y + step.y(), wrap(p.phi + step.z())};
      });
  const NormalEquations<3> at_solution = model(pose);
  const std::optional<Matrix3d> covariance = covarianceFromInformation(at_solution.hessian);
  if (!covariance) return result;
  result.status = SolveStatus::ok;
  result.pose = {{pose.x, pose.y, wrap(pose.phi)}, *covariance};
  result.chi2 = at_solution.cost;
  result.misfit = largestMisfit(seen);
  return result;
}
}  // namespace mrpt_ext
