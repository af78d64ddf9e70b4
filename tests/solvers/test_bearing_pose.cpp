#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "bearing_pose_gls.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/bearing_pose_ml.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "random_scene.h"

namespace mrpt_ext::test_bearing_pose
{
namespace
{
/// Robot in the origin facing +x; landmarks ahead, left and behind.
const std::vector<KnownBearing> kCross = {{{1, 0}, 0, 0.01}, {{0, 1}, kPi / 2, 0.01}, {{-1, 0}, kPi, 0.01}};

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

Matrix3d informationAt(const std::vector<KnownBearing>& bearings, const Pose2& pose)
{
  Matrix3d information = Matrix3d::Zero();
  for (const KnownBearing& b : bearings) addInformation(information, bearingJacobian(pose, b.landmark), b.std);
  return information;
}
}  // namespace

TEST(BearingPose, LandmarksAheadLeftAndBehindGiveTheOrigin)
{
  const BearingPoseLinear linear = solveBearingPoseLinear(kCross);
  ASSERT_EQ(linear.status, SolveStatus::ok);
  EXPECT_NEAR(linear.pose.position().norm(), 0, 1e-12);
  EXPECT_NEAR(linear.pose.phi, 0, 1e-12);
  EXPECT_NEAR(linear.r[0], 1, 1e-12);
  EXPECT_NEAR(linear.f.x(), 1, 1e-12);
  EXPECT_NEAR(solveBearingPoseGls(kCross).pose.position().norm(), 0, 1e-12);
  EXPECT_NEAR(solveBearingPoseMl(kCross).pose.mean.position().norm(), 0, 1e-12);
}

TEST(BearingPose, CovarianceOfTheCrossByHand)
{
  // Rows: ahead (0, -1, -1), left (1, 0, -1), behind (0, 1, -1), over sigma. y: (0,-1,-1) and (0,1,-1) give 2/s^2 and
  // no correlation with the heading; x and heading: [1, -1; -1, 3]/s^2 with the inverse [1.5, 0.5; 0.5, 0.5] s^2.
  const PoseMl ml = solveBearingPoseMl(kCross);
  ASSERT_EQ(ml.status, SolveStatus::ok);
  Matrix3d expected;
  expected << 1.5, 0, 0.5, 0, 0.5, 0, 0.5, 0, 0.5;
  EXPECT_LT((ml.pose.covariance / square(0.01) - expected).norm(), 1e-9);
}

TEST(BearingPose, ExactBearingsAreRecoveredByAllThree)
{
  RandomStream random(11);
  int solved = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    const Scene scene = randomScene(random, 3 + trial % 8);
    const auto bearings = measureBearings(scene, random, 0, 0.01);
    const BearingPoseLinear linear = solveBearingPoseLinear(bearings);
    if (linear.det_ratio < 1e-5) continue;  // ill-conditioned: fewer digits
    ++solved;
    const BearingPoseGls gls = solveBearingPoseGls(bearings);
    const PoseMl ml = solveBearingPoseMl(bearings);
    ASSERT_EQ(linear.status, SolveStatus::ok);
    ASSERT_EQ(gls.status, SolveStatus::ok);
    ASSERT_EQ(ml.status, SolveStatus::ok);
    EXPECT_LT(distance(linear.pose, scene.robot), 1e-7);
    EXPECT_LT(distance(gls.pose, scene.robot), 1e-7);
    EXPECT_LT(distance(ml.pose.mean, scene.robot), 1e-7);
    EXPECT_LT(std::abs(wrap(ml.pose.mean.phi - scene.robot.phi)), 1e-8);
  }
  EXPECT_GT(solved, 270);
}

TEST(BearingPose, MaximumLikelihoodIsNeverWorseThanTheClosedForms)
{
  RandomStream random(12);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Scene scene = randomScene(random, 4 + trial % 6);
    const auto bearings = measureBearings(scene, random, degToRad(2), degToRad(2));
    const PoseMl ml = solveBearingPoseMl(bearings);
    if (ml.status != SolveStatus::ok) continue;
    EXPECT_LE(ml.chi2, ml.start_chi2);
    const auto cost = [&](const std::vector<double>& residuals)
    {
      double sum = 0;
      for (const double r : residuals) sum += square(r / degToRad(2));
      return sum;
    };
    const BearingPoseLinear linear = solveBearingPoseLinear(bearings);
    const BearingPoseGls gls = solveBearingPoseGls(bearings);
    if (linear.status == SolveStatus::ok)
    {
      EXPECT_LE(ml.chi2, cost(linear.residuals) + 1e-9);
    }
    if (gls.status == SolveStatus::ok)
    {
      EXPECT_LE(ml.chi2, cost(gls.residuals) + 1e-9);
    }
  }
}

TEST(BearingPose, OnlyTheLinearFormMissesTheCramerRaoLimit)
{
  RandomStream random(13);
  const double sigma = degToRad(0.2);
  std::vector<double> ratio_linear, ratio_gls, ratio_ml;
  for (int s = 0; s < 40; ++s)
  {
    const Scene scene = randomScene(random, 8);
    const auto covariance =
        covarianceFromInformation(informationAt(measureBearings(scene, random, 0, sigma), scene.robot));
    ASSERT_TRUE(covariance);
    double linear = 0, gls = 0, ml = 0;
    for (int trial = 0; trial < 40; ++trial)
    {
      const auto bearings = measureBearings(scene, random, sigma, sigma);
      linear += square(distance(solveBearingPoseLinear(bearings).pose, scene.robot)) / 40;
      gls += square(distance(solveBearingPoseGls(bearings).pose, scene.robot)) / 40;
      ml += square(distance(solveBearingPoseMl(bearings).pose.mean, scene.robot)) / 40;
    }
    const double limit = covariance->topLeftCorner<2, 2>().trace();
    ratio_linear.push_back(std::sqrt(linear / limit));
    ratio_gls.push_back(std::sqrt(gls / limit));
    ratio_ml.push_back(std::sqrt(ml / limit));
  }
  const auto median = [](std::vector<double> v)
  {
    std::nth_element(v.begin(), v.begin() + 20, v.end());
    return v[20];
  };
  EXPECT_GT(median(ratio_linear), 1.5);
  EXPECT_NEAR(median(ratio_gls), 1.0, 0.1);
  EXPECT_NEAR(median(ratio_ml), 1.0, 0.1);
}

TEST(BearingPose, ReportedCovarianceMatchesTheScatter)
{
  RandomStream random(14);
  const Scene scene{{{0, 0}, {8, 1}, {7, 9}, {1, 6}}, {4, 3, 0.7}};
  const double sigma = degToRad(0.5);
  const int trials = 4000;
  Matrix3d scatter = Matrix3d::Zero(), reported = Matrix3d::Zero();
  for (int trial = 0; trial < trials; ++trial)
  {
    const PoseMl ml = solveBearingPoseMl(measureBearings(scene, random, sigma, sigma));
    ASSERT_EQ(ml.status, SolveStatus::ok);
    Vector3d e = ml.pose.mean.vector() - scene.robot.vector();
    e.z() = wrap(e.z());
    scatter += e * e.transpose() / trials;
    reported += ml.pose.covariance / trials;
  }
  // Whitened by the report, the scatter is the identity within the sampling error, 1/sqrt(2000) per entry.
  const Matrix3d L = reported.llt().matrixL();
  const Matrix3d whitened = L.inverse() * scatter * L.inverse().transpose();
  EXPECT_LT((whitened - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.12);
}

TEST(BearingPose, StandardDeviationsWeigh)
{
  // A wild fourth bearing hardly matters when it says so.
  std::vector<KnownBearing> bearings = kCross;
  bearings.push_back({{0, -2}, -kPi / 2 + 0.5, 1.0});
  EXPECT_LT(solveBearingPoseMl(bearings).pose.mean.position().norm(), 1e-3);
  bearings.back().std = 0.01;
  EXPECT_GT(solveBearingPoseMl(bearings).pose.mean.position().norm(), 0.05);
}

TEST(BearingPose, NoiseNeverMakesItDivergeOrReturnNaN)
{
  RandomStream random(15);
  for (int trial = 0; trial < 2000; ++trial)
  {
    Scene scene = randomScene(random, 3 + trial % 4);
    const auto bearings = measureBearings(scene, random, trial % 2 ? 0.3 : 3.0, 0.3);
    const PoseMl ml = solveBearingPoseMl(bearings);
    EXPECT_TRUE(isFinite(ml.pose.mean) && ml.pose.covariance.allFinite() && std::isfinite(ml.chi2));
    if (ml.status != SolveStatus::ok)
    {
      EXPECT_EQ(ml.pose.mean.vector(), Vector3d::Zero());
    }
    if (ml.status == SolveStatus::ok)
    {
      EXPECT_GT(ml.pose.covariance.diagonal().minCoeff(), 0);
    }
  }
}

TEST(BearingPose, DegenerateInputIsNamed)
{
  // Everything on the unit circle.
  const std::vector<Vector2d> circle = {{1, 0}, {0, 1}, {-1, 0}};
  const Pose2 robot{0, -1, 0.2};
  std::vector<KnownBearing> bearings;
  for (const Vector2d& l : circle) bearings.push_back({l, predictBearing(robot, l), 0.01});
  EXPECT_EQ(solveBearingPoseLinear(bearings).status, SolveStatus::degenerate);
  EXPECT_EQ(solveBearingPoseGls(bearings).status, SolveStatus::degenerate);
  EXPECT_EQ(solveBearingPoseMl(bearings).status, SolveStatus::degenerate);
  bearings.pop_back();
  EXPECT_EQ(solveBearingPoseMl(bearings).status, SolveStatus::too_few);
  bearings = kCross;
  bearings[1].std = 0;
  EXPECT_EQ(solveBearingPoseMl(bearings).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext::test_bearing_pose
