#include "mrpt_ext/filter/motion/motion_model.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext::test_motion_model
{
namespace
{
constexpr std::size_t kParticles = 40000;
const MotionModel kModel{
    .std_xy_per_m = 0.05, .std_phi_per_deg = 0.3, .std_phi_per_m = 0.04, .std_xy_per_s = 0.01, .std_phi_per_s = 0.02};

struct Spread
{
  Vector3d mean = Vector3d::Zero();
  Matrix3d covariance = Matrix3d::Zero();
};

Spread spreadOf(const ParticleSet& particles)
{
  Spread spread;
  for (std::size_t i = 0; i < kParticles; ++i) spread.mean += particles.pose(i).vector() / kParticles;
  for (std::size_t i = 0; i < kParticles; ++i)
  {
    Vector3d d = particles.pose(i).vector() - spread.mean;
    d.z() = wrap(d.z());
    spread.covariance += d * d.transpose() / kParticles;
  }
  return spread;
}

/// Mean and covariance of many robots that start at `start` and make `steps` equal motions.
Spread spreadAfter(const MotionModel& model, const OdometryMotion& motion, int steps, const Pose2& start = {})
{
  ParticleSet particles;
  for (std::size_t i = 0; i < kParticles; ++i) particles.add(start, 0);
  RandomStream random(11);
  for (int k = 0; k < steps; ++k) sampleMotion(particles, model, motion, random);
  return spreadOf(particles);
}

OdometryMotion straight(double length, double duration) { return {{length, 0, 0}, length, 0, duration}; }

/// The standard deviations agree within the sampling error of kParticles (0.35 % each).
void expectSameStd(const Matrix3d& a, const Matrix3d& b, double tolerance = 0.02)
{
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(std::sqrt(a(i, i)), std::sqrt(b(i, i)), tolerance * std::sqrt(b(i, i)) + 1e-12) << "axis " << i;
}
}  // namespace

TEST(MotionModel, ParametersAreStandardDeviationsAfterOneUnit)
{
  const MotionModel distance{
      .std_xy_per_m = 0.05, .std_phi_per_deg = 0, .std_phi_per_m = 0.04, .std_xy_per_s = 0, .std_phi_per_s = 0};
  EXPECT_TRUE(incrementStd(distance, {.path_length = 1}).isApprox(Vector3d(0.05, 0.05, 0.04), 1e-12));
  const MotionModel rotation{
      .std_xy_per_m = 0, .std_phi_per_deg = 0.3, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  EXPECT_NEAR(incrementStd(rotation, {.turned = degToRad(1)}).z(), degToRad(0.3), 1e-12);
  EXPECT_NEAR(incrementStd(rotation, {.turned = degToRad(90)}).z(), degToRad(0.3) * std::sqrt(90), 1e-12);
  const MotionModel time{
      .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0.01, .std_phi_per_s = 0.02};
  EXPECT_TRUE(incrementStd(time, {.duration = 4}).isApprox(Vector3d(0.02, 0.02, 0.04), 1e-12));
  EXPECT_EQ(incrementStd(kModel, {}), Vector3d::Zero());
}

TEST(MotionModel, VariancesAddUpAlongThePath)
{
  const OdometryMotion whole{{}, 3.0, 2.0, 6.0}, part{{}, 0.3, 0.2, 0.6};
  const Vector3d variance = incrementStd(kModel, whole).cwiseAbs2();
  EXPECT_TRUE(variance.isApprox(10 * incrementStd(kModel, part).cwiseAbs2(), 1e-12));
}

TEST(MotionModel, ATurnOnTheSpotSpreadsParticlesAsTheModelPredicts)
{
  const OdometryMotion turning{{0.001, 0, 0.5}, 0.001, 0.5, 1.0};
  const Spread spread = spreadAfter(kModel, turning, 1);
  expectSameStd(spread.covariance, incrementCovariance(kModel, turning));
  EXPECT_NEAR(spread.mean.z(), 0.5, 1e-3);
}

TEST(MotionModel, NoiseIsAppliedInTheRobotFrame)
{
  MotionModel model = kModel;
  model.type = MotionType::velocity;
  model.std_xy_per_s = 0;
  model.std_phi_per_m = model.std_phi_per_s = 0;
  const Spread spread = spreadAfter(model, straight(1, 1), 1, {2, 3, kPi / 2});
  EXPECT_NEAR(spread.mean.x(), 2, 1e-6);
  EXPECT_NEAR(spread.mean.y(), 4, 1e-3);
  EXPECT_NEAR(std::sqrt(spread.covariance(1, 1)), 0.05, 0.001);
}

TEST(MotionModel, ParticlesHaveTheCovarianceOfTheIncrement)
{
  for (const OdometryMotion& motion : {straight(2, 1), OdometryMotion{{1, 0.5, 0.4}, 1.2, 0.6, 2.0}})
  {
    const Matrix3d expected = incrementCovariance(kModel, motion);
    const Matrix3d found = spreadAfter(kModel, motion, 1).covariance;
    expectSameStd(found, expected);
    const Vector3d std = expected.diagonal().cwiseSqrt();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) EXPECT_NEAR(found(i, j), expected(i, j), 0.02 * std[i] * std[j]) << i << j;
  }
}

TEST(MotionModel, ManySmallIncrementsHaveTheCovarianceOfOneLargeIncrement)
{
  const int steps = 40;
  const Spread once = spreadAfter(kModel, straight(4, 8), 1);
  const Spread often = spreadAfter(kModel, straight(4.0 / steps, 8.0 / steps), steps);
  expectSameStd(often.covariance, once.covariance, 0.03);
  const double scale = std::sqrt(once.covariance(1, 1) * once.covariance(2, 2));
  EXPECT_NEAR(often.covariance(1, 2), once.covariance(1, 2), 0.03 * scale);
  EXPECT_NEAR(often.mean.x(), once.mean.x(), 0.01 * 4);
}

TEST(MotionModel, OneIncrementOfAPathThatTurnsFirstHasTheCovarianceOfItsParts)
{
  std::vector<OdometryRecord> records;
  for (int k = 0; k <= 40; ++k)
    records.push_back({0.1 * k, k <= 20 ? Pose2{0, 0, 0.05 * k}
                                        : Pose2{0.1 * (k - 20) * std::cos(1.0), 0.1 * (k - 20) * std::sin(1.0), 1}});
  const OdometryPath path(records, {});
  const Matrix3d whole = incrementCovariance(kModel, path.between(0, 4));
  ParticleSet particles;
  for (std::size_t i = 0; i < kParticles; ++i) particles.add({0, 0, 0}, 0);
  RandomStream random(3);
  for (int k = 0; k < 40; ++k) sampleMotion(particles, kModel, path.between(0.1 * k, 0.1 * (k + 1)), random);
  const Matrix3d parts = spreadOf(particles).covariance;
  expectSameStd(parts, whole, 0.03);
  // A turn missed at the beginning swings all of the chord: evenly along it this would be half of it.
  const Vector2d across(-std::sin(1.0), std::cos(1.0));
  EXPECT_NEAR(across.dot(parts.topRightCorner<2, 1>()), across.dot(whole.topRightCorner<2, 1>()),
              0.03 * std::abs(across.dot(whole.topRightCorner<2, 1>())));
}

TEST(MotionModel, ParticlesAndKalmanFilterAgreeOnEverySystematicError)
{
  const MotionModel exact{
      .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  const OdometryPath path({{0, {0, 0, 0}}, {1, {0, 0, 0.8}}, {2, {1.2, 0.4, 1.1}}, {3, {1.5, 1.9, 0.7}}}, {});
  const OdometryMotion motion = path.between(0.3, 3);
  for (const BiasKind kind :
       {BiasKind::distance_scale, BiasKind::rotation_scale, BiasKind::arc_scale, BiasKind::veer, BiasKind::drift})
  {
    const BiasModel model{{.kind = kind, .mean = 0.1, .std = 0.1}};
    ParticleSet particles({0, 0}, model);
    particles.add({1, 2, 0.5}, 0);
    particles.bias = {{0.1F}};
    RandomStream random(1);
    sampleMotion(particles, exact, motion, random);
    const Pose2 expected = predict(startingState({{1, 2, 0.5}, Matrix3d::Zero()}, model), model, exact, motion).pose();
    EXPECT_TRUE(particles.pose(0).vector().isApprox(expected.vector(), 1e-5)) << static_cast<int>(kind);
    EXPECT_GT((expected.vector() - compose({1, 2, 0.5}, motion.increment).vector()).norm(), 0.01);
  }
}

TEST(MotionModel, TheSourcesOfNoiseAddUpToTheStatedOne)
{
  OdometryMotion motion{{1.2, 0.3, 0.4}, 1.4, 0.5, 2};
  motion.excess = Vector3d(0.01, 0.02, 0.03).asDiagonal();
  Matrix3d sum = motion.excess;
  for (const Matrix3d& source : covarianceBySource(MotionModel{}, motion)) sum += source;
  EXPECT_TRUE(sum.isApprox(incrementCovariance(MotionModel{}, motion), 1e-12));
}

TEST(MotionModel, TheVelocityModelHasNoLateralNoise)
{
  MotionModel model = kModel;
  model.type = MotionType::velocity;
  model.std_xy_per_s = 0;
  EXPECT_EQ(incrementStd(model, straight(2, 1)).y(), 0);
  EXPECT_NEAR(incrementStd(model, straight(2, 1)).x(), 0.05 * std::sqrt(2), 1e-12);
  model.std_phi_per_m = model.std_phi_per_s = 0;
  EXPECT_NEAR(spreadAfter(model, straight(2, 1), 1).covariance(1, 1), 0, 1e-12);
}

TEST(MotionModel, ARandomWalkIgnoresTheIncrement)
{
  MotionModel model = kModel;
  model.type = MotionType::random_walk;
  model.std_xy_per_s = 0.3;
  const Spread spread = spreadAfter(model, {{5, 3, 1}, 0, 0, 4.0}, 1, {1, 2, 0.5});
  EXPECT_NEAR(spread.mean.x(), 1, 0.02);
  EXPECT_NEAR(spread.mean.y(), 2, 0.02);
  EXPECT_NEAR(spread.mean.z(), 0.5, 0.002);
  EXPECT_NEAR(std::sqrt(spread.covariance(0, 0)), 0.6, 0.012);
}

TEST(MotionModel, WithoutNoiseParticlesMoveByTheExactIncrement)
{
  const MotionModel exact{
      .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  ParticleSet particles;
  particles.add({1, 2, 3}, -1.5);
  RandomStream random(1);
  sampleMotion(particles, exact, {{0.5, 0.1, 0.4}, 0.6, 0.4, 1}, random);
  const Pose2 expected = compose({1, 2, 3}, {0.5, 0.1, 0.4});
  EXPECT_NEAR(particles.x[0], expected.x, 1e-6);
  EXPECT_NEAR(particles.y[0], expected.y, 1e-6);
  EXPECT_NEAR(particles.phi[0], expected.phi, 1e-6);
  EXPECT_EQ(particles.log_weight[0], -1.5);
}

TEST(MotionModel, EachParticleAppliesItsOwnOdometryScaleErrors)
{
  const MotionModel exact{
      .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  ParticleSet particles({0, 0}, {{.kind = BiasKind::distance_scale}, {.kind = BiasKind::rotation_scale}});
  for (int i = 0; i < 2; ++i) particles.add({1, 2, 0}, 0);
  particles.bias = {{0.0F, 0.1F}, {0.0F, -0.2F}};
  RandomStream random(1);
  sampleMotion(particles, exact, {{0.5, 0.1, 0.4}, 0.6, 0.4, 1}, random);
  EXPECT_TRUE(particles.pose(0).vector().isApprox(compose({1, 2, 0}, {0.5, 0.1, 0.4}).vector(), 1e-6));
  const Vector2d chord = 1.1 * (rotation(-0.2 * 0.4 / 2) * Vector2d(0.5, 0.1));
  EXPECT_TRUE(particles.pose(1).vector().isApprox(Vector3d(1 + chord.x(), 2 + chord.y(), 0.8 * 0.4), 1e-6));
}

TEST(MotionModel, TheResultDoesNotDependOnTheNumberOfThreads)
{
  const auto moved = [](unsigned threads)
  {
    ParticleSet particles;
    for (std::size_t i = 0; i < kParticles; ++i) particles.add({0, 0, 0}, 0);
    RandomStream random(7);
    sampleMotion(particles, kModel, straight(1, 1), random, threads);
    return particles.x;
  };
  EXPECT_EQ(moved(1), moved(2));
}
}  // namespace mrpt_ext::test_motion_model
