#include "mrpt_ext/solvers/window_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "trajectory_scene.h"

namespace mrpt_ext::test_window_pose
{
namespace
{
const std::vector<Vector2d> kLandmarks{{4, 1}, {1, 5}, {-3, -2}, {6, -3}, {-2, 4}};
constexpr double kStdBearing = degToRad(0.3), kStdRange = 0.02;
const Vector3d kStepNoise(0.02, 0.02, degToRad(1.0));

PoseMeasurement measured(PoseMeasurement::Kind kind, const Vector2d& landmark, const Pose2& truth, const Pose2& sensor,
                         RandomStream& random)
{
  PoseMeasurement m{kind, landmark, 0, kind == PoseMeasurement::Kind::bearing ? kStdBearing : kStdRange, {}};
  m.value = predict(m, truth) + m.std * random.gaussian();
  m.T_robot_sensor = sensor;
  return m;
}

/// Bearings (and one range) to the landmarks from every pose of the drive, at the poses that odometry gives.
std::vector<WindowMeasurements> measuredAlong(const DrivenTrajectory& drive, RandomStream& random)
{
  std::vector<WindowMeasurements> readings;
  for (std::size_t k = 0; k < drive.poses.size(); ++k)
  {
    WindowMeasurements reading{drive.covariances[k], {}};
    for (const Vector2d& l : kLandmarks)
      reading.measurements.push_back(
          measured(PoseMeasurement::Kind::bearing, l, drive.true_poses[k], drive.poses[k], random));
    reading.measurements.push_back(
        measured(PoseMeasurement::Kind::range, kLandmarks[0], drive.true_poses[k], drive.poses[k], random));
    readings.push_back(std::move(reading));
  }
  return readings;
}

double squaredError(const PoseMl& fit, const Pose2& truth)
{
  const Pose2& p = fit.pose.mean;
  const Vector3d e(p.x - truth.x, p.y - truth.y, wrap(p.phi - truth.phi));
  return e.dot(fit.pose.covariance.inverse() * e);
}

/// The same readings as if they were independent: the variance by odometry is added to that of each reading.
std::vector<PoseMeasurement> asIndependent(const std::vector<WindowMeasurements>& readings, const Pose2& pose)
{
  std::vector<PoseMeasurement> rows;
  for (const WindowMeasurements& reading : readings)
    for (PoseMeasurement m : reading.measurements)
    {
      const JacobianRow row = jacobian(m, pose) * composeJacobianSecond(pose);
      m.std = std::sqrt(square(m.std) + row * reading.odometry_covariance * row.transpose());
      rows.push_back(m);
    }
  return rows;
}
}  // namespace

TEST(WindowPose, WithoutOdometryErrorItEqualsRefinePose)
{
  RandomStream random(1);
  const DrivenTrajectory drive = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 5, Vector3d::Zero(), random);
  const std::vector<WindowMeasurements> readings = measuredAlong(drive, random);
  const PoseMl window = refineWindowPose(readings, drive.now());
  const PoseMl plain = refinePose(asIndependent(readings, drive.now()), drive.now());
  ASSERT_EQ(window.status, SolveStatus::ok);
  EXPECT_LT((window.pose.mean.vector() - plain.pose.mean.vector()).norm(), 1e-7);
  EXPECT_LT((window.pose.covariance - plain.pose.covariance).norm(), 1e-7 * plain.pose.covariance.norm());
  EXPECT_NEAR(window.chi2, plain.chi2, 1e-6);
  EXPECT_EQ(window.residuals.size(), plain.residuals.size());
}

TEST(WindowPose, IsGeneralisedLeastSquaresWithTheJointCovariance)
{
  RandomStream random(2);
  const DrivenTrajectory drive = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 4, kStepNoise, random);
  const std::vector<WindowMeasurements> readings = measuredAlong(drive, random);
  const PoseMl fit = refineWindowPose(readings, drive.now());
  ASSERT_EQ(fit.status, SolveStatus::ok);
  const Pose2& pose = fit.pose.mean;

  // The full covariance matrix of all readings.
  const Matrix3d to_world = composeJacobianSecond(pose);
  std::vector<JacobianRow> rows;
  std::vector<std::size_t> time;
  std::vector<double> error, std;
  for (std::size_t k = 0; k < readings.size(); ++k)
    for (const PoseMeasurement& m : readings[k].measurements)
    {
      rows.emplace_back(jacobian(m, pose));
      error.push_back(residual(m, pose));
      std.push_back(m.std);
      time.push_back(k);
    }
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd C(n, n), J(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
    {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Matrix3d shared = to_world * readings[std::max(time[a], time[b])].odometry_covariance *
                              to_world.transpose();  // of the newer one
      C(i, j) = rows[a] * shared * rows[b].transpose() + (i == j ? square(std[a]) : 0);
      J.row(i) = rows[a];
    }
  const Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(error.data(), n);
  const Eigen::MatrixXd W = C.inverse();
  EXPECT_NEAR(e.dot(W * e), fit.chi2, 1e-6 * fit.chi2);
  const Matrix3d information = J.transpose() * W * J;
  EXPECT_LT((information.inverse() - fit.pose.covariance).norm(), 1e-6 * fit.pose.covariance.norm());
  const Vector3d step = information.inverse() * (J.transpose() * W * e);
  EXPECT_LT(std::sqrt(step.dot(information * step)), 0.02) << "the solution is stationary";
}

TEST(WindowPose, ItsErrorIsConsistentWithItsCovarianceButIndependenceIsOverconfident)
{
  RandomStream random(3);
  const int trials = 600;
  double shared = 0, independent = 0, chi2 = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const DrivenTrajectory drive = driveSteps({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)},
                                              {0.2, 0, random.uniform(-0.2, 0.2)}, 10, kStepNoise, random);
    const std::vector<WindowMeasurements> readings = measuredAlong(drive, random);
    const PoseMl fit = refineWindowPose(readings, drive.now());
    ASSERT_EQ(fit.status, SolveStatus::ok);
    EXPECT_TRUE(fit.converged);
    shared += squaredError(fit, drive.now()) / trials;
    chi2 += fit.chi2 / trials;
    independent += squaredError(refinePose(asIndependent(readings, drive.now()), drive.now()), drive.now()) / trials;
  }
  // Squared error over covariance has mean 3 and variance 6: 99.9 % band of the mean over 600 trials.
  EXPECT_NEAR(shared, 3, 3.3 * std::sqrt(6.0 / trials));
  EXPECT_GT(independent, 4.5);
  EXPECT_NEAR(chi2, 11 * 6 - 3, 2) << "the residuals are consistent too";
}

TEST(WindowPose, OldReadingsAreNeverMorePreciseThanTheOdometrySinceThen)
{
  RandomStream random(4);
  const DrivenTrajectory drive = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 6, kStepNoise, random);
  std::vector<WindowMeasurements> readings = measuredAlong(drive, random);
  for (std::size_t k = 1; k < readings.size(); ++k) readings[k].measurements.clear();
  // All measurements are from the first pose, repeated a hundred times.
  const std::vector<PoseMeasurement> once = readings[0].measurements;
  for (int repeat = 1; repeat < 100; ++repeat)
    readings[0].measurements.insert(readings[0].measurements.end(), once.begin(), once.end());
  const PoseMl fit = refineWindowPose(readings, drive.now());
  ASSERT_EQ(fit.status, SolveStatus::ok);
  const Matrix3d to_world = composeJacobianSecond(fit.pose.mean);
  const Matrix3d floor = to_world * readings[0].odometry_covariance * to_world.transpose();
  const Matrix3d above = fit.pose.covariance - floor;
  EXPECT_GT(above.diagonal().minCoeff(), 0);
  EXPECT_LT(above.norm(), 0.1 * floor.norm());
}

TEST(WindowPose, ReportsWhyThereIsNoSolution)
{
  RandomStream random(5);
  const DrivenTrajectory drive = driveSteps({}, {0.3, 0, 0}, 1, kStepNoise, random);
  std::vector<WindowMeasurements> readings = measuredAlong(drive, random);
  EXPECT_EQ(refineWindowPose({}, {}).status, SolveStatus::too_few);
  EXPECT_EQ(refineWindowPose(readings, {std::nan(""), 0, 0}).status, SolveStatus::bad_input);
  readings[0].odometry_covariance(0, 0) = -1;
  EXPECT_EQ(refineWindowPose(readings, {}).status, SolveStatus::bad_input);
  // One landmark alone leaves a ring of poses.
  std::vector<WindowMeasurements> ring;
  for (std::size_t k = 0; k < 2; ++k)
    for (const auto kind : {PoseMeasurement::Kind::bearing, PoseMeasurement::Kind::range})
      ring.push_back({drive.covariances[k], {measured(kind, {3, 2}, drive.true_poses[k], drive.poses[k], random)}});
  EXPECT_EQ(refineWindowPose(ring, drive.now()).status, SolveStatus::degenerate);
}
}  // namespace mrpt_ext::test_window_pose
