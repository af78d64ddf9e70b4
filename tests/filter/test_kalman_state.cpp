#include "mrpt_ext/filter/kalman/kalman_state.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext::test_kalman_state
{
namespace
{
const BiasModel kScales{{.kind = BiasKind::distance_scale, .mean = 0.04, .std = 0.1},
                        {.kind = BiasKind::rotation_scale, .mean = -0.02, .std = 0.1, .std_per_sqrt_s = 0.01},
                        {.kind = BiasKind::range_offset, .sensor = "a", .std = 0.2}};

OdometryMotion motionOf(const Pose2& increment)
{
  return {increment, increment.position().norm(), std::abs(increment.phi), 0.5};
}

double drawn(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1000001); }
}  // namespace

TEST(KalmanState, StartsFromThePoseAndThePriorOfTheSystematicErrors)
{
  const GaussianPose pose{{1, 2, 3}, Matrix3d::Identity() * 0.25};
  const KalmanState state = startingState(pose, kScales);
  ASSERT_EQ(state.mean.size(), 6);
  EXPECT_EQ(state.pose().x, 1);
  EXPECT_EQ(state.mean[3], 0.04);
  EXPECT_NEAR(state.covariance(0, 0), 0.25, 1e-9);
  EXPECT_NEAR(state.covariance(5, 5), 0.04, 1e-9);
}

TEST(KalmanState, ScaleErrorsCorrectDistanceAndRotation)
{
  const KalmanState start = startingState({{0, 0, 0}, Matrix3d::Zero()}, kScales);
  // Odometry measures a quarter of a circle without noise; the true arc is 4 % longer and turns 2 % less.
  const OdometryMotion measured = motionOf({1, 1, kPi / 2});
  const KalmanState end = predict(start, kScales, {}, measured);
  EXPECT_NEAR(end.mean[2], 0.98 * kPi / 2, 1e-12);
  EXPECT_NEAR(end.mean.head<2>().norm(), 1.04 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(std::atan2(end.mean[1], end.mean[0]), 0.98 * kPi / 4, 1e-12) << "the chord of the arc";
}

TEST(KalmanState, SystematicErrorsAreRandomWalks)
{
  const KalmanState start = startingState({}, kScales);
  const KalmanState end = predict(start, kScales, {}, {{}, 0, 0, 4});
  EXPECT_NEAR(end.covariance(4, 4) - start.covariance(4, 4), 4 * 1e-4, 1e-12);
  EXPECT_EQ(end.covariance(3, 3), start.covariance(3, 3));
}

TEST(KalmanState, ADriftOverAPathTurnsWhatIsLeftOfIt)
{
  const BiasModel drift{{.kind = BiasKind::drift, .mean = 0.001, .std = 0.01}};
  // Stands for a second, then drives 2 m ahead in a second.
  const OdometryPath path({{0, {}}, {1, {}}, {2, {2, 0, 0}}}, {});
  const KalmanState end = predict(startingState({}, drift), drift, {}, path.between(0, 2));
  EXPECT_NEAR(end.mean[2], 0.002, 1e-12);
  EXPECT_NEAR(end.mean[1], 2 * 0.001 + 2 * 0.001 / 2, 1e-8);
}

TEST(KalmanState, ArcsAreNotTurnsInPlace)
{
  const BiasModel arcs{{.kind = BiasKind::arc_scale, .mean = -0.4, .std = 0.1}};
  const OdometryPath path({{0, {}}, {1, {0, 0, 1}}, {2, {std::cos(1.25), std::sin(1.25), 1.5}}}, {});
  const KalmanState start = startingState({}, arcs);
  EXPECT_NEAR(predict(start, arcs, {}, path.between(0, 1)).mean[2], 1, 1e-12) << "in place";
  EXPECT_NEAR(predict(start, arcs, {}, path.between(1, 2)).mean[2], 0.3, 1e-12) << "an arc of half a radian";
  EXPECT_NEAR(predict(start, arcs, {}, path.between(0, 2)).mean[2], 1.3, 1e-12) << "both";
}

RC_GTEST_PROP(KalmanState, PredictsTheCovarianceWithTheJacobianOfTheMotion, ())
{
  const Pose2 pose{drawn(-5, 5), drawn(-5, 5), drawn(-3, 3)};
  const OdometryMotion motion = motionOf({drawn(-1, 1), drawn(-0.2, 0.2), drawn(-0.5, 0.5)});
  const MotionModel still{
      .std_xy_per_m = 0, .std_phi_per_deg = 0, .std_phi_per_m = 0, .std_xy_per_s = 0, .std_phi_per_s = 0};
  KalmanState state = startingState({pose, Matrix3d::Zero()}, kScales);
  BiasModel steady = kScales;
  for (BiasState& bias : steady) bias.std_per_sqrt_s = 0;
  constexpr double kStep = 1e-5;
  for (int k = 0; k < 6; ++k)
  {
    // A variance of one component alone is propagated by one column of the Jacobian.
    state.covariance.setZero();
    state.covariance(k, k) = 1;
    KalmanVector up = KalmanVector::Zero(6);
    up[k] = kStep;
    const KalmanState ahead = predict({moved(state.mean, up), state.covariance}, steady, still, motion);
    const KalmanState behind = predict({moved(state.mean, -up), state.covariance}, steady, still, motion);
    KalmanVector slope = ahead.mean - behind.mean;
    slope[2] = wrap(slope[2]);
    slope /= 2 * kStep;
    const KalmanState here = predict(state, steady, still, motion);
    RC_ASSERT((here.covariance - slope * slope.transpose()).cwiseAbs().maxCoeff() < 1e-6);
  }
}
}  // namespace mrpt_ext::test_kalman_state
