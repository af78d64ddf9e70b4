#include "mrpt_ext/filter/kalman/rigid_step.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_rigid_step
{
namespace
{
KalmanVector state(double x, double y, double phi, double bias) { return Eigen::Vector4d(x, y, phi, bias); }
}  // namespace

TEST(RigidStep, LeadsFromOneStateToTheOther)
{
  for (const double turn : {0.0, 1e-9, 1e-4, 0.3, -2.5, 3.1})
  {
    const KalmanVector from = state(3, -2, 2.9, 0.1), step = state(0.4, -0.7, turn, -0.3);
    const KalmanVector to = movedRigidly(from, step);
    EXPECT_LT((rigidStep(from, to) - step).norm(), 1e-9) << turn;
    EXPECT_LE(std::abs(to[2]), 3.1416);
    EXPECT_DOUBLE_EQ(to[3], 0.1 - 0.3);
  }
}

TEST(RigidStep, GoesOnAsItBegan)
{
  // Half a step twice is the whole: the second half is told where the first one ended.
  const KalmanVector from = state(1, 2, 0.5, 0), step = state(0.4, -0.7, 1.2, 0);
  const KalmanVector halfway = movedRigidly(from, 0.5 * step);
  const KalmanVector rest = rigidStep(halfway, movedRigidly(from, step));
  const KalmanVector change = 1e-7 * step;
  const KalmanVector by_change = rigidStepJacobian(0.5 * step) * change / 1e-7;
  EXPECT_LT((rest - 0.5 * by_change).norm(), 1e-6);
}

TEST(RigidStep, ItsJacobianIsTheDerivativeOfTheFurtherStep)
{
  const KalmanVector from = state(1, 2, 0.5, 0);
  for (const double turn : {0.0, 5e-5, 0.2, -1.4})
  {
    const KalmanVector step = state(0.4, -0.7, turn, 0.2), to = movedRigidly(from, step);
    const KalmanMatrix J = rigidStepJacobian(step);
    for (Eigen::Index k = 0; k < 4; ++k)
    {
      const KalmanVector change = 1e-6 * KalmanVector::Unit(4, k);
      const KalmanVector numeric =
          (rigidStep(to, movedRigidly(from, step + change)) - rigidStep(to, movedRigidly(from, step - change))) / 2e-6;
      EXPECT_LT((J.col(k) - numeric).norm(), 1e-6) << turn << ", column " << k;
    }
  }
}

TEST(RigidStep, PosesThatSeeALandmarkAlikeAreAStraightLine)
{
  const Vector2d landmark(5, 1);
  const Pose2 robot{2, 3, -0.4};
  const Vector2d from_landmark = robot.position() - landmark;
  const KalmanVector about = Vector3d(-from_landmark.y(), from_landmark.x(), 1), start = robot.vector();
  for (const double turn : {0.05, 0.8, -2.0})
  {
    const KalmanVector there = movedRigidly(start, turn * about);
    const Pose2 pose{there[0], there[1], there[2]};
    EXPECT_NEAR(predictRange(pose, landmark), predictRange(robot, landmark), 1e-12);
    EXPECT_NEAR(predictBearing(pose, landmark), predictBearing(robot, landmark), 1e-12);
  }
}
}  // namespace mrpt_ext::test_rigid_step
