#include "mrpt_ext/solvers/window_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "trajectory_scene.h"

namespace mrpt_ext
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

/// Bearings (and one range) to the landmarks from every place of the way, as carried by odometry.
std::vector<WindowMeasurements> measuredAlong(const DrivenTrajectory& way, RandomStream& random)
{
  std::vector<WindowMeasurements> readings;
  for (std::size_t k = 0; k < way.poses.size(); ++k)
  {
    WindowMeasurements reading{way.covariances[k], {}};
    for (const Vector2d& l : kLandmarks)
      reading.measurements.push_back(
          measured(PoseMeasurement::Kind::bearing, l, way.true_poses[k], way.poses[k], random));
    reading.measurements.push_back(
        measured(PoseMeasurement::Kind::range, kLandmarks[0], way.true_poses[k], way.poses[k], random));
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

/// The same as if independent: what odometry adds to each reading, added to that reading's own variance.
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

TEST(WindowPose, WithoutOdometryErrorItIsThePlainRefinement)
{
  RandomStream random(1);
  const DrivenTrajectory way = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 5, Vector3d::Zero(), random);
  const std::vector<WindowMeasurements> readings = measuredAlong(way, random);
  const PoseMl carried = refineCarriedPose(readings, way.now());
  const PoseMl plain = refinePose(asIndependent(readings, way.now()), way.now());
  ASSERT_EQ(carried.status, SolveStatus::ok);
  EXPECT_LT((carried.pose.mean.vector() - plain.pose.mean.vector()).norm(), 1e-7);
  EXPECT_LT((carried.pose.covariance - plain.pose.covariance).norm(), 1e-7 * plain.pose.covariance.norm());
  EXPECT_NEAR(carried.chi2, plain.chi2, 1e-6);
  EXPECT_EQ(carried.residuals.size(), plain.residuals.size());
}

TEST(WindowPose, IsGeneralisedLeastSquaresWithTheJointCovariance)
{
  RandomStream random(2);
  const DrivenTrajectory way = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 4, kStepNoise, random);
  const std::vector<WindowMeasurements> readings = measuredAlong(way, random);
  const PoseMl fit = refineCarriedPose(readings, way.now());
  ASSERT_EQ(fit.status, SolveStatus::ok);
  const Pose2& pose = fit.pose.mean;

  // The whole covariance of all readings, written out.
  const Matrix3d to_world = composeJacobianSecond(pose);
  std::vector<JacobianRow> rows;
  std::vector<std::size_t> moment;
  std::vector<double> error, std;
  for (std::size_t k = 0; k < readings.size(); ++k)
    for (const PoseMeasurement& m : readings[k].measurements)
    {
      rows.emplace_back(jacobian(m, pose));
      error.push_back(residual(m, pose));
      std.push_back(m.std);
      moment.push_back(k);
    }
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd C(n, n), J(n, 3);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
    {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Matrix3d shared = to_world * readings[std::max(moment[a], moment[b])].odometry_covariance *
                              to_world.transpose();  // the newer one's
      C(i, j) = rows[a] * shared * rows[b].transpose() + (i == j ? square(std[a]) : 0);
      J.row(i) = rows[a];
    }
  const Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(error.data(), n);
  const Eigen::MatrixXd W = C.inverse();
  EXPECT_NEAR(e.dot(W * e), fit.chi2, 1e-6 * fit.chi2);
  const Matrix3d information = J.transpose() * W * J;
  EXPECT_LT((information.inverse() - fit.pose.covariance).norm(), 1e-6 * fit.pose.covariance.norm());
  const Vector3d step = information.inverse() * (J.transpose() * W * e);
  EXPECT_LT(std::sqrt(step.dot(information * step)), 0.02) << "no step is left to take";
}

TEST(WindowPose, ItsErrorIsWhatItsCovarianceSaysWhileIndependenceIsOverConfident)
{
  RandomStream random(3);
  const int trials = 600;
  double shared = 0, independent = 0, chi2 = 0;
  for (int trial = 0; trial < trials; ++trial)
  {
    const DrivenTrajectory way = driveSteps({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)},
                                            {0.2, 0, random.uniform(-0.2, 0.2)}, 10, kStepNoise, random);
    const std::vector<WindowMeasurements> readings = measuredAlong(way, random);
    const PoseMl fit = refineCarriedPose(readings, way.now());
    ASSERT_EQ(fit.status, SolveStatus::ok);
    EXPECT_TRUE(fit.converged);
    shared += squaredError(fit, way.now()) / trials;
    chi2 += fit.chi2 / trials;
    independent += squaredError(refinePose(asIndependent(readings, way.now()), way.now()), way.now()) / trials;
  }
  // Squared error over covariance has mean 3 and variance 6: 99.9 % band of the mean over 600 trials.
  EXPECT_NEAR(shared, 3, 3.3 * std::sqrt(6.0 / trials));
  EXPECT_GT(independent, 4.5);
  EXPECT_NEAR(chi2, 11 * 6 - 3, 2) << "and so are its residuals";
}

TEST(WindowPose, OlderReadingsNeverTellMoreThanTheWayLetsThem)
{
  RandomStream random(4);
  const DrivenTrajectory way = driveSteps({0.5, 0.8, 0.6}, {0.3, 0, 0.2}, 6, kStepNoise, random);
  std::vector<WindowMeasurements> readings = measuredAlong(way, random);
  for (std::size_t k = 1; k < readings.size(); ++k) readings[k].measurements.clear();
  // Everything was measured at the first place, a hundred times over.
  const std::vector<PoseMeasurement> once = readings[0].measurements;
  for (int repeat = 1; repeat < 100; ++repeat)
    readings[0].measurements.insert(readings[0].measurements.end(), once.begin(), once.end());
  const PoseMl fit = refineCarriedPose(readings, way.now());
  ASSERT_EQ(fit.status, SolveStatus::ok);
  const Matrix3d to_world = composeJacobianSecond(fit.pose.mean);
  const Matrix3d floor = to_world * readings[0].odometry_covariance * to_world.transpose();
  const Matrix3d above = fit.pose.covariance - floor;
  EXPECT_GT(above.diagonal().minCoeff(), 0);
  EXPECT_LT(above.norm(), 0.1 * floor.norm());
}

TEST(WindowPose, WhatCannotBeSolvedSaysWhy)
{
  RandomStream random(5);
  const DrivenTrajectory way = driveSteps({}, {0.3, 0, 0}, 1, kStepNoise, random);
  std::vector<WindowMeasurements> readings = measuredAlong(way, random);
  EXPECT_EQ(refineCarriedPose({}, {}).status, SolveStatus::too_few);
  EXPECT_EQ(refineCarriedPose(readings, {std::nan(""), 0, 0}).status, SolveStatus::bad_input);
  readings[0].odometry_covariance(0, 0) = -1;
  EXPECT_EQ(refineCarriedPose(readings, {}).status, SolveStatus::bad_input);
  // One landmark, however often it is seen: a ring.
  std::vector<WindowMeasurements> ring;
  for (std::size_t k = 0; k < 2; ++k)
    for (const auto kind : {PoseMeasurement::Kind::bearing, PoseMeasurement::Kind::range})
      ring.push_back({way.covariances[k], {measured(kind, {3, 2}, way.true_poses[k], way.poses[k], random)}});
  EXPECT_EQ(refineCarriedPose(ring, way.now()).status, SolveStatus::degenerate);
}
}  // namespace mrpt_ext
