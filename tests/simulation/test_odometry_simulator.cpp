#include "mrpt_ext/simulation/odometry_simulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mrpt_ext::test_odometry_simulator
{
namespace
{
const RobotPath& bend()
{
  static const RobotPath path({0, 0, 0}, {{4, 0.5, 0}, {2, 0.5, 0.6}, {2, 0, -1}});
  return path;
}

constexpr OdometryNoise kPerfect{.std_xy_per_m = 0, .std_phi_deg_per_deg = 0, .std_phi_deg_per_m = 0};

/// Errors of the displacement over the whole path, in the frame of the true end, many times over.
std::vector<Vector3d> finalErrors(const OdometryNoise& noise, int runs)
{
  std::vector<Vector3d> errors;
  for (int run = 0; run < runs; ++run)
  {
    RandomStream random(11, static_cast<std::uint64_t>(run));
    const SimulatedOdometry odometry(bend(), noise, bend().duration(), random);
    const auto moved = odometry.displacement(0, bend().duration());
    const Pose2 truth = between(bend().poseAt(0), bend().poseAt(bend().duration()));
    errors.emplace_back(moved->mean.x - truth.x, moved->mean.y - truth.y, wrap(moved->mean.phi - truth.phi));
  }
  return errors;
}

Matrix3d covarianceOf(const std::vector<Vector3d>& errors)
{
  Matrix3d sum = Matrix3d::Zero();
  for (const Vector3d& error : errors) sum += error * error.transpose();
  return sum / static_cast<double>(errors.size());
}

OdometryNoise noisy(double rate_hz)
{
  OdometryNoise noise = kPerfect;
  noise.rate_hz = rate_hz;
  noise.std_xy_per_m = 0.03;
  noise.std_phi_deg_per_deg = 0.1;
  noise.std_phi_deg_per_m = 1;
  noise.std_xy_per_sqrt_s = 0.004;
  noise.std_phi_deg_per_sqrt_s = 0.2;
  return noise;
}
}  // namespace

TEST(SimulatedOdometry, WithoutErrorsRepeatsThePath)
{
  RandomStream random(1);
  const SimulatedOdometry odometry(bend(), kPerfect, 8, random);
  EXPECT_EQ(odometry.records().size(), 81U);
  for (const TimedPose& record : odometry.records())
  {
    EXPECT_NEAR(record.pose.x, bend().poseAt(record.time).x, 1e-5);
    EXPECT_NEAR(record.pose.y, bend().poseAt(record.time).y, 1e-5);
    EXPECT_NEAR(wrap(record.pose.phi - bend().poseAt(record.time).phi), 0, 1e-5);
  }
}

TEST(SimulatedOdometry, ArcsMayBeMeasuredTooLongWhilePivotsAreRight)
{
  OdometryNoise noise = kPerfect;
  noise.arc_scale_error = 0.5;
  RandomStream random(1);
  const SimulatedOdometry odometry(bend(), noise, 8, random);
  const double before = odometry.displacement(0, 4)->mean.phi, arc = odometry.displacement(4, 6)->mean.phi,
               pivot = odometry.displacement(6, 8)->mean.phi;
  EXPECT_NEAR(before, 0, 1e-5);
  EXPECT_NEAR(arc, 1.5 * 1.2, 1e-5);
  EXPECT_NEAR(pivot, -2, 1e-5);
}

TEST(SimulatedOdometry, DriftTurnsAtStandstillToo)
{
  OdometryNoise noise = kPerfect;
  noise.drift = 0.01;
  RandomStream random(1);
  const SimulatedOdometry odometry(RobotPath({1, 2, 0}, {}), noise, 10, random);
  EXPECT_NEAR(odometry.displacement(0, 10)->mean.phi, 0.1, 1e-5);
}

TEST(SimulatedOdometry, AVeerIsNotMeasured)
{
  OdometryNoise noise = kPerfect;
  noise.veer = 0.02;
  noise.rotation_scale_error = 0.5;
  RandomStream random(1);
  const SimulatedOdometry odometry(bend(), noise, 8, random);
  EXPECT_NEAR(odometry.displacement(0, 4)->mean.phi, -1.5 * 0.02 * bend().lengthAt(4), 1e-5);
  EXPECT_NEAR(odometry.displacement(6, 8)->mean.phi, -1.5 * 2, 1e-5);
}

TEST(SimulatedOdometry, SlipsAreRareAndLarge)
{
  OdometryNoise noise = kPerfect;
  noise.slips_per_minute = 60 / bend().duration();  // one per run
  noise.std_slip = 0.3;
  int slipped = 0;
  const int runs = 1000;
  for (const Vector3d& error : finalErrors(noise, runs)) slipped += error.norm() > 1e-3 ? 1 : 0;
  EXPECT_NEAR(slipped / static_cast<double>(runs), 1 - std::exp(-1), 0.05);
}

TEST(SimulatedOdometry, HeadingErrorIsAsConfigured)
{
  OdometryNoise noise = kPerfect;
  noise.std_phi_deg_per_deg = 0.1;
  noise.std_phi_deg_per_m = 1;
  const Matrix3d covariance = covarianceOf(finalErrors(noise, 2000));
  const double turned = radToDeg(2 * 0.6 + 2 * 1.0), length = 6 * 0.5;
  const double expected = std::sqrt(0.1 * 0.1 * turned + 1.0 * 1.0 * length);
  EXPECT_NEAR(radToDeg(std::sqrt(covariance(2, 2))), expected, 0.05 * expected);
}

TEST(SimulatedOdometry, PositionErrorIsAsConfiguredAtAnyRate)
{
  for (const double rate : {5.0, 40.0})
  {
    OdometryNoise noise = kPerfect;
    noise.rate_hz = rate;
    noise.std_xy_per_m = 0.03;
    noise.std_xy_per_sqrt_s = 0.01;
    const Matrix3d covariance = covarianceOf(finalErrors(noise, 2000));
    const double expected = std::sqrt(0.03 * 0.03 * 3 + 0.01 * 0.01 * 8);
    EXPECT_NEAR(std::sqrt(covariance(0, 0)), expected, 0.06 * expected);
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), expected, 0.06 * expected);
  }
}

TEST(SimulatedOdometry, ReportedCovarianceDescribesTheErrors)
{
  RandomStream random(5);
  const SimulatedOdometry odometry(bend(), noisy(10), 8, random);
  const Matrix3d reported = odometry.displacement(0, 8)->covariance;
  const Matrix3d seen = covarianceOf(finalErrors(noisy(10), 3000));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(seen(i, j), reported(i, j), 0.12 * std::sqrt(reported(i, i) * reported(j, j)));
}

TEST(SimulatedOdometry, ScaleErrorStretchesThePath)
{
  OdometryNoise noise = kPerfect;
  noise.scale_error = 0.02;
  RandomStream random(1);
  const RobotPath straight({0, 0, 0}, {{10, 0.5, 0}});
  EXPECT_NEAR(SimulatedOdometry(straight, noise, 10, random).displacement(0, 10)->mean.x, 5.1, 1e-4);
}

TEST(SimulatedOdometry, NoRateNoOdometry)
{
  OdometryNoise none = kPerfect;
  none.rate_hz = 0;
  RandomStream random(1);
  const SimulatedOdometry odometry(bend(), none, 8, random);
  EXPECT_TRUE(odometry.records().empty());
  EXPECT_FALSE(odometry.displacement(0, 1));
}
}  // namespace mrpt_ext::test_odometry_simulator
