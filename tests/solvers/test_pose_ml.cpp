#include "mrpt_ext/solvers/pose_ml.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/solvers/pose_information.h"

namespace mrpt_ext::test_pose_ml
{
namespace
{
using Kind = PoseMeasurement::Kind;

PoseMeasurement exact(Kind kind, const Vector2d& landmark, const Pose2& robot, const Pose2& sensor = {},
                      double std = 0.05)
{
  PoseMeasurement m{kind, landmark, 0, std, sensor};
  m.value = predict(m, robot);
  return m;
}

const Pose2 kRobot{2, 3, 0.8};
const Pose2 kCamera{0.3, -0.2, 1.1};  // on the robot: off centre and turned
}  // namespace

TEST(PoseMl, BearingsAndRangesFromATurnedSensorOffCentre)
{
  const std::vector<PoseMeasurement> measurements = {
      exact(Kind::bearing, {8, 1}, kRobot, kCamera, 0.01), exact(Kind::range, {8, 1}, kRobot, kCamera),
      exact(Kind::bearing, {1, 9}, kRobot, kCamera, 0.01), exact(Kind::range, {-4, 2}, kRobot)};
  const PoseMl ml = refinePose(measurements, {1, 1, 0});
  ASSERT_EQ(ml.status, SolveStatus::ok);
  EXPECT_LT((ml.pose.mean.vector() - kRobot.vector()).norm(), 1e-8);
  EXPECT_LT(ml.chi2, 1e-12);
  EXPECT_GT(ml.start_chi2, 1);
  EXPECT_TRUE(ml.converged);
}

TEST(PoseMl, RangesAndAHeadingAreEnough)
{
  std::vector<PoseMeasurement> measurements = {exact(Kind::range, {0, 0}, kRobot), exact(Kind::range, {9, 0}, kRobot),
                                               exact(Kind::range, {4, 9}, kRobot)};
  EXPECT_EQ(refinePose(measurements, kRobot).status, SolveStatus::degenerate) << "ranges never see the heading";
  measurements.push_back(exact(Kind::heading, {0, 0}, kRobot, {}, 0.1));
  const PoseMl ml = refinePose(measurements, {3, 4, 0});
  ASSERT_EQ(ml.status, SolveStatus::ok);
  EXPECT_LT((ml.pose.mean.vector() - kRobot.vector()).norm(), 1e-8);
  EXPECT_NEAR(ml.pose.covariance(2, 2), square(0.1), 1e-12);
}

TEST(PoseMl, RobustLossForgivesAGrossError)
{
  RandomStream random(21);
  std::vector<PoseMeasurement> measurements;
  for (int i = 0; i < 8; ++i)
    measurements.push_back(exact(Kind::bearing, {random.uniform(0, 10), random.uniform(0, 10)}, kRobot, {}, 0.01));
  measurements[3].value += 0.4;
  const auto error = [&](Loss loss)
  {
    const PoseMl ml = refinePose(measurements, {2.2, 2.8, 0.7}, loss);
    EXPECT_EQ(ml.status, SolveStatus::ok);
    return (ml.pose.mean.position() - kRobot.position()).norm();
  };
  EXPECT_GT(error(Loss::squared), 0.1);
  EXPECT_LT(error(Loss::cauchy), 0.01);
}

TEST(PoseMl, CostNeverRisesFromAnyStart)
{
  RandomStream random(22);
  for (int trial = 0; trial < 500; ++trial)
  {
    std::vector<PoseMeasurement> measurements;
    for (int i = 0; i < 5; ++i)
    {
      const Vector2d landmark(random.uniform(0, 10), random.uniform(0, 10));
      measurements.push_back({i % 2 ? Kind::range : Kind::bearing, landmark, random.uniform(0, 6), 0.1, kCamera});
    }
    const Pose2 start{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-4, 4)};
    const PoseMl ml = refinePose(measurements, start);
    EXPECT_LE(ml.chi2, ml.start_chi2);
    EXPECT_TRUE(isFinite(ml.pose.mean) && ml.pose.covariance.allFinite());
  }
}

TEST(PoseMl, BadInputIsRefused)
{
  std::vector<PoseMeasurement> measurements(3, exact(Kind::range, {1, 1}, kRobot));
  measurements[1].value = -1;
  EXPECT_EQ(refinePose(measurements, kRobot).status, SolveStatus::bad_input);
  measurements[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refinePose(measurements, kRobot).status, SolveStatus::bad_input);
  measurements.resize(1);
  EXPECT_EQ(refinePose(measurements, kRobot).status, SolveStatus::too_few);
}

TEST(PoseInformation, RatioIsOneForIndependentEqualDirectionsAndZeroWhenBlind)
{
  EXPECT_NEAR(informationRatio(Vector3d(4, 4, 900).asDiagonal()), 1, 1e-12);
  EXPECT_NEAR(informationRatio(Vector3d(1, 3, 7).asDiagonal()), 0.75, 1e-12);
  EXPECT_EQ(informationRatio(Vector3d(1, 3, 0).asDiagonal()), 0);
  EXPECT_FALSE(covarianceFromInformation(Matrix3d(Vector3d(1, 0, 2).asDiagonal())));
  const auto covariance = covarianceFromInformation(Matrix3d(Vector3d(1e-6, 4e-6, 1e6).asDiagonal()));
  ASSERT_TRUE(covariance);
  EXPECT_NEAR((*covariance)(1, 1), 2.5e5, 1e-6);
  EXPECT_NEAR((*covariance)(2, 2), 1e-6, 1e-18);
}
}  // namespace mrpt_ext::test_pose_ml
