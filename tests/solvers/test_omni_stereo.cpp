#include "mrpt_ext/solvers/omni_stereo.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/solvers/camera_yaw_calibration.h"
#include "mrpt_ext/solvers/movis_frame.h"
#include "mrpt_ext/solvers/object_position.h"
#include "mrpt_ext/solvers/origin_correction.h"
#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/two_landmark_pose.h"
#include "mrpt_ext/solvers/two_pole_pose.h"

namespace mrpt_ext::test_omni_stereo
{
TEST(Triangulation, DiagonalsMeetInTheMiddle)
{
  const Triangulation t = triangulate({{0, 0}, kPi / 4, 0.01}, {{2, 0}, 3 * kPi / 4, 0.01});
  ASSERT_EQ(t.status, SolveStatus::ok);
  EXPECT_LT((t.point.mean - Vector2d(1, 1)).norm(), 1e-12);
  EXPECT_LT((t.point.covariance - 2 * square(0.01) * Matrix2d::Identity()).norm(), 1e-12);
}

TEST(Triangulation, RoundTripWithEveryCameraPair)
{
  RandomStream random(61);
  const double L = 0.15;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Vector2d target(random.uniform(-6, 6), random.uniform(-6, 6));
    const int i = 1 + trial % 3, j = 1 + (trial + 1) % 3;
    const MovisCamera a = *movisCamera(i, L), b = *movisCamera(j, L);
    const double slant_a = angleOf(target - a.position), slant_b = angleOf(target - b.position);
    EXPECT_NEAR(wrap(a.slantFromTheta(a.thetaFromSlant(slant_a)) - slant_a), 0, 1e-12);
    if (std::abs(std::sin(slant_a - slant_b)) < 1e-4) continue;  // along the baseline
    const Triangulation t = triangulate({a.position, slant_a, 0.001}, {b.position, slant_b, 0.001});
    ASSERT_EQ(t.status, SolveStatus::ok);
    EXPECT_LT((t.point.mean - target).norm(), 1e-8);
  }
}

TEST(Triangulation, CovarianceMatchesTheScatter)
{
  RandomStream random(62);
  const Vector2d target(1.5, 2.0), a(-0.13, 0.075), b(0.13, 0.075);
  const double sigma = degToRad(0.05);
  Matrix2d scatter = Matrix2d::Zero();
  const int trials = 4000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const Triangulation t = triangulate({a, angleOf(target - a) + sigma * random.gaussian(), sigma},
                                        {b, angleOf(target - b) + sigma * random.gaussian(), sigma});
    const Vector2d e = t.point.mean - target;
    scatter += e * e.transpose() / trials;
  }
  const Matrix2d reported =
      triangulate({a, angleOf(target - a), sigma}, {b, angleOf(target - b), sigma}).point.covariance;
  EXPECT_NEAR(scatter.trace() / reported.trace(), 1, 0.1);
}

TEST(MovisFrame, ForwardIsTheirYAndOurX)
{
  EXPECT_NEAR(forwardBearingFromSlant(kPi / 2), 0, 1e-15);
  EXPECT_NEAR(slantFromForwardBearing(forwardBearingFromSlant(1.2)), 1.2, 1e-15);
  EXPECT_NEAR(headingFromSlope(0), kPi / 2, 1e-15);
  EXPECT_NEAR(slopeFromHeading(headingFromSlope(-2.9)), -2.9, 1e-12);
  EXPECT_EQ(robotFromMovis({3, 5}), Vector2d(5, -3)) << "3 to the right, 5 ahead";
  EXPECT_EQ(movisFromRobot(robotFromMovis({3, 5})), Vector2d(3, 5));
  EXPECT_FALSE(movisCamera(4, 1));
}

TEST(TwoPolePose, BothPolesAgreeOnExactPoints)
{
  const PoleField field{250, 400};
  const double beta = 2.5;  // beyond a right angle, where arctan fails
  const Vector2d robot(60, -30);
  const auto seen = [&](const Vector2d& pole) { return Vector2d(rotation(-beta) * (pole - robot)); };
  const TwoPolePose pose = solveTwoPolePose(seen({-250, 400}), seen({250, 400}), field);
  ASSERT_EQ(pose.status, SolveStatus::ok);
  EXPECT_NEAR(pose.beta, beta, 1e-12);
  EXPECT_LT((pose.world_q - robot).norm(), 1e-9);
  EXPECT_LT((pose.world_p - robot).norm(), 1e-9);
  EXPECT_NEAR(pose.misfit, 0, 1e-9);
  EXPECT_NEAR(robotPose(pose).phi, wrap(beta + kPi / 2), 1e-12);
}

TEST(TwoPolePose, MisfitIsTheWrongLength)
{
  EXPECT_NEAR(solveTwoPolePose({-260, 400}, {250, 400}, {250, 400}).misfit, 10, 1e-12);
}

TEST(OriginCorrection, IsExactAtTheOrigin)
{
  const PoleField field{250, 400};
  const Vector2d p(-263, 371), q(241, 422);
  const OriginCorrection correction = calibrateAtOrigin(p, q, field);
  ASSERT_EQ(correction.status, SolveStatus::ok);
  const TwoPolePose pose = solveTwoPolePose(correctLeftPole(correction, p), correctRightPole(correction, q), field);
  EXPECT_NEAR(pose.beta, 0, 1e-12);
  EXPECT_LT(pose.world_mean.norm(), 1e-9);
}

TEST(CameraYaw, FindsTheTurnAndItsUncertainty)
{
  RandomStream random(63);
  const Pose2 camera{0.1, -0.05, 0.7};
  std::vector<CalibrationSighting> sightings;
  for (int i = 0; i < 400; ++i)
  {
    const Vector2d landmark(i % 2 ? -2.5 : 2.5, 4);
    const Pose2 robot{0, 0, kPi / 2};
    const double noise = 0.002 * random.gaussian();
    sightings.push_back({robot, landmark, wrap(predictBearing(robot, landmark, camera) + 3.0 + noise)});
  }
  const CameraYaw yaw = calibrateCameraYaw(sightings, camera);
  ASSERT_EQ(yaw.status, SolveStatus::ok);
  EXPECT_NEAR(yaw.offset, 3.0, 4 * 0.0001);
  EXPECT_NEAR(yaw.scatter, 0.002, 0.0003);
  EXPECT_NEAR(yaw.std_offset, 0.0001, 0.00002);
  EXPECT_EQ(calibrateCameraYaw({}, camera).status, SolveStatus::too_few);
}

TEST(CameraYaw, LeavesOutWhatDoesNotAgree)
{
  const Pose2 camera{0.1, -0.05, 0.7};
  const auto sighting = [&](double x, double turn)
  {
    const Pose2 robot{0, 0, kPi / 2};
    return CalibrationSighting{robot, {x, 4}, wrap(predictBearing(robot, {x, 4}, camera) + turn), degToRad(0.1)};
  };
  const double right = degToRad(0.4), wrong = degToRad(8);
  const CameraYaw one_wrong =
      calibrateCameraYaw(std::vector{sighting(-2.5, right), sighting(2.5, wrong), sighting(2.5, right)}, camera);
  ASSERT_EQ(one_wrong.status, SolveStatus::ok);
  EXPECT_NEAR(one_wrong.offset, right, 1e-9);
  EXPECT_EQ(one_wrong.used, 2u);
  // Of two nobody knows which is right, one alone cannot be checked, and half of them are no majority.
  const CameraYaw two = calibrateCameraYaw(std::vector{sighting(-2.5, right), sighting(2.5, wrong)}, camera);
  EXPECT_EQ(two.status, SolveStatus::none);
  EXPECT_NEAR(two.spread, wrong - right, 1e-9);
  EXPECT_EQ(calibrateCameraYaw(std::vector{sighting(-2.5, right)}, camera).status, SolveStatus::too_few);
  EXPECT_EQ(
      calibrateCameraYaw(
          std::vector{sighting(-2.5, right), sighting(2.5, right), sighting(-2.5, wrong), sighting(2.5, wrong)}, camera)
          .status,
      SolveStatus::none);
}

TEST(PointPose, TwoLandmarksByHand)
{
  // Robot at (1, 1) facing +y: (1, 4) is 3 ahead, (0, 1) is 1 to the left.
  const Matrix2d c = 0.01 * Matrix2d::Identity();
  const std::vector<SeenLandmark> seen = {{{1, 4}, {{3, 0}, c}}, {{0, 1}, {{0, 1}, c}}};
  const PointPose pose = solvePointPose(seen);
  ASSERT_EQ(pose.status, SolveStatus::ok);
  EXPECT_LT((pose.pose.mean.vector() - Vector3d(1, 1, kPi / 2)).norm(), 1e-9);
  EXPECT_NEAR(pose.misfit, 0, 1e-12);
  // Heading variance of two points: 2 sigma^2 / distance^2.
  EXPECT_NEAR(pose.pose.covariance(2, 2), 2 * 0.01 / 10, 1e-9);
  EXPECT_EQ(solvePointPose(std::span(seen).first(1)).status, SolveStatus::too_few);
  EXPECT_EQ(solvePointPose(std::vector<SeenLandmark>{seen[0], seen[0]}).status, SolveStatus::degenerate);
}

TEST(PointPose, CovarianceMatchesTheScatter)
{
  RandomStream random(64);
  const Pose2 robot{1, 2, 2.2};
  const std::vector<Vector2d> landmarks = {{4, 5}, {-2, 3}, {1, -3}};
  const double sr = 0.05, sb = 0.01;
  Matrix3d scatter = Matrix3d::Zero(), reported = Matrix3d::Zero();
  const int trials = 3000;
  for (int trial = 0; trial < trials; ++trial)
  {
    std::vector<SeenLandmark> seen;
    for (const Vector2d& l : landmarks)
    {
      const double r = predictRange(robot, l) + sr * random.gaussian();
      const double b = predictBearing(robot, l) + sb * random.gaussian();
      const Vector2d u = direction(b), n = perpendicular(u);
      seen.push_back({l, {r * u, square(sr) * u * u.transpose() + square(r * sb) * n * n.transpose()}});
    }
    const PointPose pose = solvePointPose(seen);
    Vector3d e = pose.pose.mean.vector() - robot.vector();
    e.z() = wrap(e.z());
    scatter += e * e.transpose() / trials;
    reported += pose.pose.covariance / trials;
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(scatter(i, i) / reported(i, i), 1, 0.12) << i;
}

TEST(ObjectPosition, AddsThePoseAndTheSighting)
{
  // Facing +y, the ball 2 ahead: a heading error of 0.1 moves it 0.2 along x.
  const GaussianPose robot{{1, 1, kPi / 2}, Matrix3d(Vector3d(0.04, 0.09, 0.01).asDiagonal())};
  const GaussianPoint ball = objectPosition(robot, {{2, 0}, Matrix2d(Vector2d(0.25, 0).asDiagonal())});
  EXPECT_LT((ball.mean - Vector2d(1, 3)).norm(), 1e-12);
  EXPECT_NEAR(ball.covariance(0, 0), 0.04 + 0.04, 1e-12);
  EXPECT_NEAR(ball.covariance(1, 1), 0.09 + 0.25, 1e-12);
}
}  // namespace mrpt_ext::test_omni_stereo
