#include "mrpt_ext/solvers/window_landmark.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "trajectory_scene.h"

namespace mrpt_ext::test_window_landmark
{
namespace
{
constexpr double kStdBearing = degToRad(0.3), kStdRange = 0.02;
const Vector3d kStepNoise(0.01, 0.01, degToRad(0.5));
const Vector2d kLandmark{2.5, 3};

struct Senses
{
  bool bearing = false, range = false;
};

WindowObservation observation(const DrivenTrajectory& drive, std::size_t k, const Senses& senses,
                              RandomStream* random = nullptr)
{
  WindowObservation s{drive.poses[k], drive.covariances[k], {}, {}, kStdBearing, kStdRange};
  const auto noise = [&](double std) { return random ? std * random->gaussian() : 0.0; };
  if (senses.bearing) s.bearing = predictBearing(drive.true_poses[k], kLandmark) + noise(kStdBearing);
  if (senses.range) s.range = predictRange(drive.true_poses[k], kLandmark) + noise(kStdRange);
  return s;
}

std::vector<WindowObservation> observedAlong(const DrivenTrajectory& drive, const Senses& senses,
                                             RandomStream* random = nullptr)
{
  std::vector<WindowObservation> observations;
  for (std::size_t k = 0; k < drive.poses.size(); ++k) observations.push_back(observation(drive, k, senses, random));
  return observations;
}

Vector2d truthInRobot(const DrivenTrajectory& drive) { return transform(inverse(drive.now()), kLandmark); }

const Pose2 kEnd{0.5, 0.2, 0.1};
const Pose2 kStraight{0.25, 0, 0}, kBend{0.25, 0, 0.25};
DrivenTrajectory exactDrive(const Pose2& step, int steps)
{
  RandomStream unused(0);
  DrivenTrajectory drive = driveSteps(kEnd, step, steps, Vector3d::Zero(), unused);
  return drive;
}
}  // namespace

TEST(WindowLandmark, RangesAlongAStraightTrajectoryLeaveTwoMirrorImages)
{
  const DrivenTrajectory drive = exactDrive(kStraight, 6);
  const WindowLandmark found = locateLandmark(observedAlong(drive, {.range = true}));
  ASSERT_EQ(found.status, SolveStatus::ok);
  ASSERT_EQ(found.candidates.size(), 2u);
  const Vector2d truth = truthInRobot(drive);
  const Vector2d a = found.candidates[0].in_robot.mean, b = found.candidates[1].in_robot.mean;
  EXPECT_LT(std::min((a - truth).norm(), (b - truth).norm()), 1e-6);
  EXPECT_NEAR(a.x(), b.x(), 1e-6);
  EXPECT_NEAR(a.y(), -b.y(), 1e-6);
}

TEST(WindowLandmark, RangesAlongACurvedTrajectoryGiveOnePoint)
{
  const DrivenTrajectory drive = exactDrive(kBend, 6);
  const WindowLandmark found = locateLandmark(observedAlong(drive, {.range = true}));
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_LT((found.candidates[0].in_robot.mean - truthInRobot(drive)).norm(), 1e-6);
}

TEST(WindowLandmark, BearingsFromTwoOrMorePositionsGiveOnePoint)
{
  for (const int steps : {2, 6})
  {
    const DrivenTrajectory drive = exactDrive(kStraight, steps);
    const WindowLandmark found = locateLandmark(observedAlong(drive, {.bearing = true}));
    ASSERT_EQ(found.candidates.size(), 1u);
    EXPECT_LT((found.candidates[0].in_robot.mean - truthInRobot(drive)).norm(), 1e-6);
  }
}

TEST(WindowLandmark, ABearingAndALaterRangeGiveAPoint)
{
  const DrivenTrajectory drive = exactDrive(kBend, 6);
  const WindowLandmark found =
      locateLandmark(std::vector{observation(drive, 0, {.bearing = true}), observation(drive, 6, {.range = true})});
  ASSERT_EQ(found.status, SolveStatus::ok);
  const bool has_truth =
      std::any_of(found.candidates.begin(), found.candidates.end(),
                  [&](const LocalizedLandmark& p) { return (p.in_robot.mean - truthInRobot(drive)).norm() < 1e-6; });
  EXPECT_TRUE(has_truth);
}

TEST(WindowLandmark, ABearingDecidesBetweenTheMirrorImages)
{
  const DrivenTrajectory drive = exactDrive(kStraight, 6);
  std::vector<WindowObservation> observations = observedAlong(drive, {.range = true});
  observations[3] = observation(drive, 3, {.bearing = true, .range = true});
  const WindowLandmark found = locateLandmark(observations);
  ASSERT_EQ(found.candidates.size(), 1u);
  EXPECT_LT((found.candidates[0].in_robot.mean - truthInRobot(drive)).norm(), 1e-6);
}

TEST(WindowLandmark, ItsErrorIsConsistentWithItsCovariance)
{
  RandomStream random(6);
  const int trials = 800;
  for (const Senses senses : {Senses{true, false}, Senses{false, true}, Senses{true, true}})
  {
    double squared = 0, chi2 = 0;
    int found_it = 0, readings = 0;
    for (int trial = 0; trial < trials; ++trial)
    {
      const DrivenTrajectory drive = driveSteps(kEnd, kBend, 8, kStepNoise, random);
      const WindowLandmark found = locateLandmark(observedAlong(drive, senses, &random));
      if (found.status != SolveStatus::ok) continue;
      ++found_it;
      readings = found.readings;
      const LocalizedLandmark& best = found.candidates.front();
      const Vector2d e = best.in_robot.mean - truthInRobot(drive);
      squared += e.dot(best.in_robot.covariance.inverse() * e);
      chi2 += best.chi2;
    }
    EXPECT_GE(found_it, 0.99 * trials);
    // Mean 2, variance 4.
    EXPECT_NEAR(squared / found_it, 2, 0.35) << senses.bearing << senses.range;
    EXPECT_NEAR(chi2 / found_it, readings - 2, 0.08 * readings) << senses.bearing << senses.range;
  }
}

TEST(WindowLandmark, RangesAlongTheLineOfSightLeaveALargeCovarianceAcrossIt)
{
  RandomStream random(7);
  const DrivenTrajectory drive =
      driveSteps({0, 0, std::atan2(3, 2.5)}, {0.3, 0, 0}, 4, Vector3d(0.001, 0.001, 0.001), random);
  const WindowLandmark found = locateLandmark(observedAlong(drive, {.range = true}));
  ASSERT_EQ(found.status, SolveStatus::ok);
  const GaussianPoint& p = found.candidates.front().in_robot;
  EXPECT_NEAR(p.mean.norm(), kLandmark.norm(), 0.1) << "the range is known";
  EXPECT_GT(p.covariance(1, 1), 100 * p.covariance(0, 0));
  EXPECT_LT(p.covariance(1, 1), square(2.0));
}

TEST(WindowLandmark, ReportsWhyThereIsNoSolution)
{
  const auto status = [](const std::vector<WindowObservation>& s) { return locateLandmark(s).status; };
  const DrivenTrajectory drive = exactDrive(kStraight, 6);
  EXPECT_EQ(status({}), SolveStatus::too_few);
  EXPECT_EQ(status({observation(drive, 0, {.range = true})}), SolveStatus::too_few);
  const WindowObservation bearing = observation(drive, 0, {.bearing = true});
  EXPECT_NE(status({bearing, bearing}), SolveStatus::ok) << "no parallax";
  WindowObservation parallel = observation(drive, 6, {.bearing = true});
  parallel.bearing = bearing.bearing;
  EXPECT_NE(status({bearing, parallel}), SolveStatus::ok) << "parallel bearings";
  parallel.bearing = *bearing.bearing - degToRad(0.3);
  EXPECT_NE(status({bearing, parallel}), SolveStatus::ok) << "they diverge";
  WindowObservation bad = bearing;
  bad.std_bearing = 0;
  EXPECT_EQ(status({bad, bearing}), SolveStatus::bad_input);
  bad = observation(drive, 0, {.range = true});
  bad.range = -1;
  EXPECT_EQ(status({bad, bearing}), SolveStatus::bad_input);
}

TEST(WindowLandmark, NeverReturnsNaN)
{
  RandomStream random(8);
  for (int trial = 0; trial < 3000; ++trial)
  {
    std::vector<WindowObservation> observations;
    for (int k = 0; k < 2 + trial % 4; ++k)
    {
      WindowObservation s{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)}};
      s.odometry_covariance = square(0.01 * (4 - k)) * Matrix3d::Identity();
      s.std_bearing = s.std_range = 0.05;
      if (random.chance(0.6)) s.bearing = random.uniform(-3, 3);
      if (random.chance(0.6)) s.range = random.uniform(0, 3) * (trial % 7 > 0);
      observations.push_back(s);
    }
    const WindowLandmark found = locateLandmark(observations);
    EXPECT_NE(found.status, SolveStatus::bad_input);
    EXPECT_EQ(found.candidates.empty(), found.status != SolveStatus::ok);
    for (const LocalizedLandmark& p : found.candidates)
    {
      EXPECT_TRUE(p.in_robot.mean.allFinite() && p.in_robot.covariance.allFinite() && p.chi2 >= 0);
      EXPECT_GT(p.in_robot.covariance.determinant(), 0);
    }
  }
}
}  // namespace mrpt_ext::test_window_landmark
