#include "mrpt_ext/filter/consider/excess_noise.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_excess_noise
{
namespace
{
const MotionModel kStated{.std_xy_per_m = 0.05,
                          .std_phi_per_deg = 0.3,
                          .std_phi_per_m = degToRad(1.0),
                          .std_xy_per_s = 0.005,
                          .std_phi_per_s = degToRad(0.2)};

/// A Kalman filter that trusts the stated noise, of a robot that is measured now and then, and its own innovations.
class LinearRun
{
 public:
  LinearRun(double true_factor, std::uint64_t seed) : factor_(true_factor), random_(seed, 1) {}

  /// Motions of one second; every `rest`th is followed by a measurement of the pose.
  /// `push`: what the true pose moves to the left beside that.
  void step(ExcessNoise& noise, int rest, double lasting = 0, bool right = true, double push = 0)
  {
    const OdometryMotion motion{{0.5, 0, 0.3}, 0.5, 0.3, 1};
    LinearStep step{.motion = motion, .before = {Eigen::Vector3d::Zero(), covariance_}};
    step.motion_jacobian = Matrix3d::Identity();
    OdometryMotion adapted = motion;
    adapted.excess = noise.excess(motion);
    step.predicted = {Eigen::Vector3d::Zero(), covariance_ + incrementCovariance(kStated, adapted)};
    error_ += factor_ * drawn(incrementCovariance(kStated, motion));
    error_.y() += push;
    step.remaining = KalmanMatrix::Identity(3, 3);
    step.posterior = step.predicted.covariance;
    if (++count_ % rest == 0) measure(step);
    noise.update(step, Eigen::VectorXd::Constant(static_cast<Eigen::Index>(step.rows.size()), lasting));
    if (right) noise.confirm();
    covariance_ = step.posterior;
  }

 private:
  void measure(LinearStep& step)
  {
    const double variance = square(0.02);
    const Matrix3d P = step.predicted.covariance, R = variance * Matrix3d::Identity();
    const Matrix3d gain = P * (P + R).inverse();
    Vector3d innovation;
    for (int k = 0; k < 3; ++k)
    {
      innovation[k] = error_[k] + std::sqrt(variance) * random_.gaussian();
      InnovationRow row;
      row.row.residual = innovation[k];
      row.row.jacobian = KalmanRowVector::Unit(3, k);
      row.row.variance = variance;
      row.variance = P(k, k) + variance;
      step.rows.push_back(row);
      step.gains.push_back(gain.col(k));
    }
    step.remaining = Matrix3d::Identity() - gain;
    step.posterior = step.remaining * P;
    error_ -= gain * innovation;
  }

  Vector3d drawn(const Matrix3d& covariance)
  {
    const Vector3d white(random_.gaussian(), random_.gaussian(), random_.gaussian());
    return Eigen::LLT<Matrix3d>(covariance).matrixL() * white;
  }

  double factor_;
  RandomStream random_;
  int count_ = 0;
  Vector3d error_ = Vector3d::Zero();  // true pose minus estimate
  Matrix3d covariance_ = square(0.02) * Matrix3d::Identity();
};

double largest(const PerNoiseSource<double>& factors) { return *std::max_element(factors.begin(), factors.end()); }

Matrix3d excessAfter(double factor, std::uint64_t seed, double lasting = 0)
{
  ExcessNoise noise(kStated, 3);
  LinearRun run(factor, seed);
  for (int k = 0; k < 300; ++k) run.step(noise, 2, lasting);
  return noise.excess({{0.5, 0, 0.3}, 0.5, 0.3, 1});
}

TEST(ExcessNoise, NothingIsKnownAtTheStart)
{
  const ExcessNoise noise(kStated, 3);
  EXPECT_EQ(largest(noise.factors()), 1);
  EXPECT_EQ(noise.excess({{1, 0, 0.5}, 1, 0.5, 1}), Matrix3d(Matrix3d::Zero()));
}

TEST(ExcessNoise, TheVarianceOfTheMotionIsFound)
{
  const Matrix3d stated = incrementCovariance(kStated, {{0.5, 0, 0.3}, 0.5, 0.3, 1});
  double heading = 0, position = 0;
  constexpr int kRuns = 200;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed)
  {
    const Matrix3d excess = excessAfter(3, seed);
    heading += excess(2, 2) / stated(2, 2) / kRuns;
    position += excess(0, 0) / stated(0, 0) / kRuns;
  }
  // Nine times the stated variance: eight beyond it. First steps that err much leave less weight to the later ones, so
  // the mean is a little more.
  EXPECT_NEAR(heading, 8, 2);
  EXPECT_NEAR(position, 8, 2);
}

TEST(ExcessNoise, WhatOneKindOfMotionShowsIsExpectedOfTheOthers)
{
  // Half a minute of arcs; a rest was not seen alone. Eight times the stated variance beyond it would be right.
  const OdometryMotion rest{{}, 0, 0, 10};
  const Matrix3d stated = incrementCovariance(kStated, rest);
  double heading = 0;
  constexpr int kRuns = 20;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed)
  {
    ExcessNoise noise(kStated, 3);
    LinearRun run(3, seed);
    for (int k = 0; k < 30; ++k) run.step(noise, 2);
    heading += noise.excess(rest)(2, 2) / stated(2, 2) / kRuns;
  }
  EXPECT_GT(heading, 3);
  EXPECT_LT(heading, 9);
}

TEST(ExcessNoise, ADriveAsStatedAddsLittle)
{
  const Matrix3d stated = incrementCovariance(kStated, {{0.5, 0, 0.3}, 0.5, 0.3, 1});
  double heading = 0;
  constexpr int kRuns = 20;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) heading += excessAfter(1, seed)(2, 2) / stated(2, 2) / kRuns;
  EXPECT_LT(heading, 0.3);
}

TEST(ExcessNoise, ErrorsOfMeasurementsThatLastHideNoise)
{
  EXPECT_LT(excessAfter(2, 1, square(10.0))(2, 2), 0.1 * excessAfter(2, 1)(2, 2));
}

TEST(ExcessNoise, ItIsKeptWhenTheEstimateStartsAnew)
{
  ExcessNoise noise(kStated, 3);
  LinearRun run(3, 7);
  for (int k = 0; k < 100; ++k) run.step(noise, 5);
  const double before = largest(noise.factors());
  noise.restart();
  EXPECT_GT(before, 1.5);
  EXPECT_EQ(largest(noise.factors()), before);
}

TEST(ExcessNoise, WhatNoConfirmedEstimateShowedIsForgotten)
{
  const auto after = [](bool restarts)
  {
    ExcessNoise noise(kStated, 3);
    LinearRun run(3, 7);
    noise.confirm();
    for (int k = 0; k < 100; ++k) run.step(noise, 5, 0, false);
    EXPECT_EQ(largest(noise.factors()), 1) << "it may be a wrong pose";
    if (restarts) noise.restart();
    noise.confirm();
    return largest(noise.factors());
  };
  EXPECT_GT(after(false), 1.5);
  EXPECT_LT(after(false), 20) << "nine times the stated variance is right";
  EXPECT_EQ(after(true), 1);
}

TEST(ExcessNoise, WhatWasSeenBeforeThePoseWasFoundIsNotOfOdometry)
{
  ExcessNoise noise(kStated, 3);
  LinearRun run(3, 7);
  for (int k = 0; k < 100; ++k) run.step(noise, 5, 0, false);
  noise.confirm();
  EXPECT_EQ(largest(noise.factors()), 1);
}

// The filter follows measurements once it takes odometry for bad; then innovations tell hardly anything about odometry.
TEST(ExcessNoise, AFewSurprisesDoNotMakeOdometryBadForMinutes)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    ExcessNoise noise(kStated, 3);
    LinearRun run(1, seed);
    for (int k = 0; k < 20; ++k) run.step(noise, 1);
    for (int k = 0; k < 3; ++k) run.step(noise, 1, 0, true, 0.3);
    EXPECT_LT(largest(noise.factors()), 30);
    for (int k = 0; k < 60; ++k) run.step(noise, 1);
    EXPECT_LT(largest(noise.factors()), 4) << "seed " << seed;
  }
}

TEST(ExcessNoise, ARandomWalkHasNoOdometryThatCouldErr)
{
  ExcessNoise noise(walkingSpeedRandomWalk(), 3);
  LinearRun run(3, 7);
  for (int k = 0; k < 100; ++k) run.step(noise, 5);
  EXPECT_EQ(noise.excess({{1, 0, 0.5}, 1, 0.5, 1}), Matrix3d(Matrix3d::Zero()));
}
}  // namespace
}  // namespace mrpt_ext::test_excess_noise
