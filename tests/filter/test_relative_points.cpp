#include "mrpt_ext/filter/integrity/relative_points.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <vector>

namespace mrpt_ext::test_relative_points
{
namespace
{
const Matrix2d kNoise = Vector2d(0.04, 0.01).asDiagonal();
const Matrix3d kTurned = Vector3d(0, 0, 0.04).asDiagonal();  // by 0.2 rad, or not

double largest(const Matrix2d& covariance)
{
  return Eigen::SelfAdjointEigenSolver<Matrix2d>(covariance).eigenvalues().maxCoeff();
}
}  // namespace

TEST(RelativePoints, MoveAgainstTheRobot)
{
  RelativePoints points;
  points.add({2, 1}, kNoise);
  points.move({1, 0, kPi / 2}, Matrix3d::Zero());
  EXPECT_NEAR((points.position(0) - Vector2d(1, -1)).norm(), 0, 1e-12);
  EXPECT_NEAR(points.covariance(0)(0, 0), 0.01, 1e-12) << "the axes have turned";
  EXPECT_NEAR(points.covariance(0)(1, 1), 0.04, 1e-12);
}

TEST(RelativePoints, AnUnknownTurnMovesFarPointsAcross)
{
  RelativePoints points;
  points.add({3, 0}, kNoise);
  points.move({}, kTurned);
  EXPECT_NEAR(points.covariance(0)(0, 0), 0.04, 1e-12);
  EXPECT_NEAR(points.covariance(0)(1, 1), 0.01 + 9 * 0.04, 1e-12);
}

TEST(RelativePoints, TheUncertaintyOfAStepIsThatOfAllPoints)
{
  const std::vector<Vector2d> at{{3, 0.5}, {-1, 2}};
  const Pose2 step{0.4, -0.2, 0.7};
  const Matrix3d factor = (Matrix3d() << 0.1, 0, 0, 0.05, 0.08, 0, -0.03, 0.02, 0.06).finished();
  RelativePoints points;
  for (const Vector2d& point : at) points.add(point, Matrix2d::Zero());
  points.move(step, factor * factor.transpose());
  for (Eigen::Index k = 0; k < 2; ++k)
  {
    const auto seen_from = [&](const Vector3d& by) {
      return transform(inverse(Pose2{step.x + by.x(), step.y + by.y(), step.phi + by.z()}), at[k]);
    };
    Eigen::Matrix<double, 2, 3> jacobian;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d by = 1e-6 * Vector3d::Unit(axis);
      jacobian.col(axis) = (seen_from(by) - seen_from(-by)) / 2e-6;
    }
    const Matrix2d expected = jacobian * factor * factor.transpose() * jacobian.transpose();
    EXPECT_NEAR((points.covariance(k) - expected).norm(), 0, 1e-8);
  }
}

TEST(RelativePoints, OneThatIsSeenAgainTellsWhereTheOthersAre)
{
  const Matrix2d precise = 1e-6 * Matrix2d::Identity();
  RelativePoints points;
  for (const Vector2d& point : {Vector2d(3, 0), Vector2d(0, 3), Vector2d(-2, 2)}) points.add(point, precise);
  points.move({}, kTurned);
  const double before = largest(points.covariance(1));
  const Matrix2d turned = rotation(-0.1);  // the robot turned by 0.1 rad, and odometry did not notice
  points.update(0, turned * Vector2d(3, 0), precise);
  EXPECT_LT(largest(points.covariance(1)), 1e-3 * before);
  EXPECT_NEAR((points.position(1) - turned * Vector2d(0, 3)).norm(), 0, 0.02) << "to first order";
  EXPECT_NEAR((points.position(2) - turned * Vector2d(-2, 2)).norm(), 0, 0.02);
}

TEST(RelativePoints, IsKnownNoBetterThanOneMeasurementTells)
{
  RelativePoints points;
  points.add({3, 0}, 4 * kNoise);
  for (int k = 0; k < 50; ++k) points.update(0, {3.1, -0.1}, kNoise);
  EXPECT_NEAR((points.covariance(0) - kNoise).norm(), 0, 1e-9);
  EXPECT_LT((points.position(0) - Vector2d(3.1, -0.1)).norm(), Vector2d(0.1, 0.1).norm()) << "drawn towards it";
}

TEST(RelativePoints, ARemovedOneLeavesTheOthersAsTheyAre)
{
  RelativePoints points;
  for (const Vector2d& point : {Vector2d(3, 0), Vector2d(0, 3), Vector2d(-2, 2)}) points.add(point, kNoise);
  points.move({0.1, 0, 0}, kTurned);
  RelativePoints fewer = points;
  fewer.remove(1);
  ASSERT_EQ(fewer.size(), 2);
  EXPECT_EQ(fewer.position(0), points.position(0));
  EXPECT_EQ(fewer.position(1), points.position(2));
  fewer.update(0, {2.9, 0.2}, kNoise);
  points.update(0, {2.9, 0.2}, kNoise);
  EXPECT_NEAR((fewer.position(1) - points.position(2)).norm(), 0, 1e-12);
  EXPECT_NEAR((fewer.covariance(1) - points.covariance(2)).norm(), 0, 1e-12);
}
}  // namespace mrpt_ext::test_relative_points
