#include "mrpt_ext/solvers/running_fix.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/solvers/heading_from_landmark.h"
#include "mrpt_ext/solvers/landmark_in_robot_frame.h"
#include "mrpt_ext/solvers/pose_ring.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext::test_running_fix
{
namespace
{
const Vector2d kGoalPost{1.5, 0.45};

/// What a robot at `second` logs after driving `displacement` (in the frame of its first pose).
RunningFixReading drive(const Pose2& second, const Pose2& displacement, const Pose2& sensor)
{
  const Pose2 first = compose(second, inverse(displacement));
  RunningFixReading fix;
  fix.T_robot_sensor = sensor;
  fix.displacement = displacement;
  fix.first_range = predictRange(first, kGoalPost, sensor);
  fix.second_range = predictRange(second, kGoalPost, sensor);
  fix.second_bearing = predictBearing(second, kGoalPost, sensor);
  fix.first_std = fix.second_std = 0.01;
  fix.second_bearing_std = 0.02;
  fix.displacement_covariance = Vector3d(1e-5, 1e-5, 1e-5).asDiagonal();
  return fix;
}
}  // namespace

TEST(RunningFix, RightAngleAtTheLandmark)
{
  // From (4, 0) to (0, 3) about a landmark in the origin: second place (0, 3) or its mirror image about the motion.
  const RunningFix fix = runningFix({{0, 0}, {-4, 3}, 4, 3, 0.1, 0.1});
  ASSERT_EQ(fix.candidates.size(), 2u);
  const bool first = (fix.candidates[0].second.mean - Vector2d(0, 3)).norm() < 1e-9;
  const RunningFixCandidate& truth = fix.candidates[first ? 0 : 1];
  EXPECT_LT((truth.second.mean - Vector2d(0, 3)).norm(), 1e-9);
  EXPECT_LT((truth.first - Vector2d(4, 0)).norm(), 1e-9);
  // The two ranges measure x and y independently.
  EXPECT_LT((truth.second.covariance - 0.01 * Matrix2d::Identity()).norm(), 1e-9);
}

TEST(RunningFix, MissingCirclesGiveTheMiddleOfTheGapWithALargeCovariance)
{
  const RunningFix fix = runningFix({{0, 0}, {1, 0}, 3, 1, 0.1, 0.1});  // |r1 - r2| = 2 > 1
  EXPECT_EQ(fix.status, SolveStatus::ok);
  EXPECT_EQ(fix.relation, CircleRelation::contained);
  EXPECT_FALSE(fix.intersects);
  ASSERT_EQ(fix.candidates.size(), 1u);
  EXPECT_NEAR(fix.gap, 1, 1e-12);
  EXPECT_NEAR(fix.candidates[0].second.mean.x(), -1.5, 1e-12);
  EXPECT_GT(fix.candidates[0].second.covariance(1, 1), 1);
  EXPECT_GT(fix.candidates[0].second.covariance(0, 0), 0.25);
  EXPECT_FALSE(fix.candidates[0].linearised);
}

TEST(RunningFix, CovarianceMatchesTheScatter)
{
  RandomStream random(51);
  const RangePair exact{{0, 0},
                        {-0.4, 0.5},
                        std::hypot(1.4, 0.5),
                        1.4142135623730951,
                        0.01,
                        0.01,
                        Matrix2d(Vector2d(1e-4, 4e-4).asDiagonal())};
  const Vector2d truth(1, 1);
  Matrix2d scatter = Matrix2d::Zero(), reported = Matrix2d::Zero();
  const int trials = 4000;
  for (int trial = 0; trial < trials; ++trial)
  {
    RangePair noisy = exact;
    noisy.first_range += 0.01 * random.gaussian();
    noisy.second_range += 0.01 * random.gaussian();
    noisy.displacement += Vector2d(0.01 * random.gaussian(), 0.02 * random.gaussian());
    const RunningFix fix = runningFix(noisy);
    const auto nearest = std::min_element(fix.candidates.begin(), fix.candidates.end(),
                                          [&](const RunningFixCandidate& a, const RunningFixCandidate& b)
                                          { return (a.second.mean - truth).norm() < (b.second.mean - truth).norm(); });
    const Vector2d e = nearest->second.mean - truth;
    scatter += e * e.transpose() / trials;
    reported += nearest->second.covariance / trials;
  }
  EXPECT_NEAR(scatter(0, 0) / reported(0, 0), 1, 0.12);
  EXPECT_NEAR(scatter(1, 1) / reported(1, 1), 1, 0.12);
}

TEST(RunningFix, NeverNaNAndAlwaysACandidateWhenTheCirclesAreApart)
{
  RandomStream random(52);
  for (int trial = 0; trial < 3000; ++trial)
  {
    const RangePair pair{{random.uniform(-1, 1), random.uniform(-1, 1)},
                         {random.uniform(-1, 1) * (trial % 3), random.uniform(-1, 1)},
                         random.uniform(0, 2),
                         random.uniform(0, 2),
                         trial % 2 ? 0.05 : 0.0,
                         0.05};
    const RunningFix fix = runningFix(pair);
    ASSERT_EQ(fix.status, SolveStatus::ok);
    ASSERT_FALSE(fix.candidates.empty());
    for (const RunningFixCandidate& c : fix.candidates)
      EXPECT_TRUE(c.second.mean.allFinite() && c.second.covariance.allFinite());
  }
  EXPECT_EQ(runningFix({{0, 0}, {0, 0}, 1, 1, 0.1, 0.1}).status, SolveStatus::degenerate);
  EXPECT_EQ(runningFix({{0, 0}, {0, 0}, 1, 2, 0.1, 0.1}).status, SolveStatus::none);
  EXPECT_EQ(runningFix({{0, 0}, {1, 0}, -1, 2, 0.1, 0.1}).status, SolveStatus::bad_input);
}

TEST(RunningFixPose, AKnownHeadingGivesTheRobotEvenForASensorOffCentre)
{
  const Pose2 truth{0.6, 0.8, 0.4}, sensor{0.1, 0.05, 0.3};
  const RunningFixReading fix = drive(truth, {0.3, 0.1, 0.5}, sensor);
  const RunningFixPoses poses = runningFixPoses(fix, kGoalPost, {truth.phi, 0.02});
  ASSERT_EQ(poses.candidates.size(), 2u);
  EXPECT_LT((poses.candidates[0].pose.mean.position() - truth.position()).norm(), 1e-9);
  EXPECT_GT(poses.candidates[0].log_score, poses.candidates[1].log_score + 3) << "the bearing tells them apart";
}

TEST(RunningFixPose, CovarianceCountsTheHeadingErrorAndTheTurnOfTheDisplacement)
{
  RandomStream random(53);
  const Pose2 truth{0.6, 0.8, 0.4}, sensor{0.1, 0.05, 0.3}, displacement{0.3, 0.25, 0.5};
  Matrix3d scatter = Matrix3d::Zero();
  const int trials = 4000;
  const RunningFixReading exact = drive(truth, displacement, sensor);
  const Matrix3d reported = runningFixPoses(exact, kGoalPost, {truth.phi, 0.03}).candidates[0].pose.covariance;
  for (int trial = 0; trial < trials; ++trial)
  {
    RunningFixReading noisy = exact;
    noisy.second_bearing.reset();
    noisy.first_range += 0.01 * random.gaussian();
    noisy.second_range += 0.01 * random.gaussian();
    const double s = std::sqrt(1e-5);
    noisy.displacement = {displacement.x + s * random.gaussian(), displacement.y + s * random.gaussian(),
                          displacement.phi + s * random.gaussian()};
    const double heading = truth.phi + 0.03 * random.gaussian();
    Vector3d best(1e9, 1e9, 1e9);
    for (const RunningFixPose& c : runningFixPoses(noisy, kGoalPost, {heading, 0.03}).candidates)
      if (const Vector3d e = c.pose.mean.vector() - truth.vector(); e.head<2>().norm() < best.head<2>().norm())
        best = e;
    scatter += best * best.transpose() / trials;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(scatter(i, j), reported(i, j), 0.12 * std::sqrt(reported(i, i) * reported(j, j))) << i << j;
}

TEST(PoseRing, EveryPoseOfTheRingSeesTheSameThing)
{
  const Pose2 sensor{0.2, 0.1, 0.5};
  const PoseRing ring = makePoseRing(kGoalPost, 2.0, 0.03, 0.7, 0.02, sensor);
  for (double heading = -3; heading < 3; heading += 0.37)
  {
    const Pose2 pose = poseOnRing(ring, heading);
    EXPECT_NEAR(predictRange(pose, kGoalPost, sensor), 2.0, 1e-12);
    EXPECT_NEAR(predictBearing(pose, kGoalPost, sensor), 0.7, 1e-12);
    const GaussianPose g = gaussianOnRing(ring, heading, 0.01);
    const JacobianRow row = rangeJacobian(pose, kGoalPost, sensor.position());
    EXPECT_NEAR(row * g.covariance * row.transpose(), square(0.03), 1e-9) << "the range stays as certain as measured";
  }
}

TEST(PoseRing, HeadingsGiveTheirPosesWithTheirProbabilities)
{
  // A landmark 2 m ahead in the origin, the robot heads along y or half a turn back: golden values.
  const PoseRing ring = makePoseRing({0, 0}, 2.0, 0.03, 0, 0.01);
  const auto poses = posesOnRing(ring, Facing::either({kPi / 2, 0.1}, {-kPi / 2, 0.2}, 0.25));
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].probability, 0.75);
  EXPECT_LT((poses[0].pose.mean.vector() - Vector3d(0, -2, kPi / 2)).norm(), 1e-12);
  EXPECT_LT((poses[1].pose.mean.vector() - Vector3d(0, 2, -kPi / 2)).norm(), 1e-12);
  Matrix3d expected;
  // Across: 2 m times the errors of heading and bearing; along: the range; a turn to the left moves the robot to the
  // right.
  expected << 4 * (square(0.1) + square(0.01)), 0, 2 * square(0.1), 0, square(0.03), 0, 2 * square(0.1), 0, square(0.1);
  EXPECT_LT((poses[0].pose.covariance - expected).norm(), 1e-12) << poses[0].pose.covariance;
  EXPECT_EQ(posesOnRing(ring, Facing::single(1, 0.1)).size(), 1U);
}

TEST(LandmarkInRobotFrame, TruthOrItsMirrorImage)
{
  const Vector2d v(2, 1), d(0.5, 0);  // driving straight ahead: the mirror image is (2, -1)
  const LandmarkInRobotFrame r = landmarkInRobotFrame(d, (v + d).norm(), v.norm());
  ASSERT_EQ(r.count, 2);
  EXPECT_NEAR(r.candidates[0].x(), 2, 1e-9);
  EXPECT_NEAR(std::abs(r.candidates[0].y()), 1, 1e-9);
  EXPECT_NEAR(r.candidates[0].y(), -r.candidates[1].y(), 1e-12);
}

TEST(HeadingFromLandmark, AllQuadrants)
{
  for (double truth = -3; truth < 3.1; truth += 0.5)
    for (double around = -3; around < 3.1; around += 0.5)
    {
      const Vector2d position = kGoalPost + 2 * Vector2d(std::cos(around), std::sin(around));
      const Vector2d in_robot = transform(inverse({position.x(), position.y(), truth}), kGoalPost);
      const auto heading = headingFromLandmark(kGoalPost, position, in_robot);
      ASSERT_TRUE(heading);
      EXPECT_NEAR(wrap(*heading - truth), 0, 1e-12);
    }
  EXPECT_FALSE(headingFromBearing(kGoalPost, kGoalPost, 0.1));
}
}  // namespace mrpt_ext::test_running_fix
