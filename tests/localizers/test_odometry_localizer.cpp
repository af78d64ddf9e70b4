#include "mrpt_ext/localizers/odometry_localizer.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_odometry_localizer
{
namespace
{
const GaussianPose kStart{{1, 2, 0.5}, Vector3d(0.01, 0.04, 0.0025).asDiagonal()};

Frame moved(double time, const Pose2& increment)
{
  return {.time = time, .motion = {increment, increment.position().norm(), std::abs(increment.phi), 0.5}};
}
}  // namespace

TEST(OdometryLocalizer, StartsAtTheGivenPose)
{
  OdometryLocalizer odometry({}, kStart);
  EXPECT_EQ(odometry.name(), "odometry");
  EXPECT_TRUE(odometry.continuous());
  const Estimate estimate = odometry.process({.time = 3});
  ASSERT_TRUE(estimate.point);
  EXPECT_EQ(estimate.status, SolveStatus::ok);
  EXPECT_EQ(estimate.point->time, 3);
  EXPECT_EQ(estimate.point->pose.mean.vector(), kStart.mean.vector());
  EXPECT_TRUE(estimate.point->pose.covariance.isApprox(kStart.covariance));
}

TEST(OdometryLocalizer, AddsUpTheIncrements)
{
  OdometryLocalizer odometry({}, {{0, 0, 0}, Matrix3d::Zero()});
  for (int k = 0; k < 4; ++k) (void)odometry.process(moved(k, {1, 0, kPi / 2}));  // a square
  const Estimate back = odometry.process(moved(4, {2, 0, 0}));
  EXPECT_NEAR(back.point->pose.mean.x, 2, 1e-12);
  EXPECT_NEAR(back.point->pose.mean.y, 0, 1e-12);
  EXPECT_NEAR(std::abs(wrap(back.point->pose.mean.phi)), 0, 1e-12);
}

TEST(OdometryLocalizer, CovarianceIsThatOfPropagatedParticles)
{
  const MotionModel model;
  OdometryLocalizer odometry(model, kStart);
  RandomStream random(1);
  ParticleSet robots;
  constexpr int kCount = 40000;
  for (int i = 0; i < kCount; ++i)
  {
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
    robots.add({1 + 0.1 * a, 2 + 0.2 * b, 0.5 + 0.05 * c}, 0);
  }
  Estimate estimate;
  for (int k = 0; k < 20; ++k)
  {
    const Frame frame = moved(k, {0.2, 0.02, 0.1});
    sampleMotion(robots, model, frame.motion, random);
    estimate = odometry.process(frame);
  }
  const GaussianPose& pose = estimate.point->pose;
  Matrix3d sampled = Matrix3d::Zero();
  for (int i = 0; i < kCount; ++i)
  {
    const Pose2 robot = robots.pose(static_cast<std::size_t>(i));
    const Vector3d d(robot.x - pose.mean.x, robot.y - pose.mean.y, wrap(robot.phi - pose.mean.phi));
    sampled += d * d.transpose() / kCount;
  }
  EXPECT_LT((pose.covariance - sampled).norm(), 0.06 * sampled.norm()) << pose.covariance << "\n\n" << sampled;
}
}  // namespace mrpt_ext::test_odometry_localizer
