#include "mrpt_ext/solvers/pose_from_landmarks.h"

#include <gtest/gtest.h>

#include "cramer_rao_trials.h"
#include "mrpt_ext/solvers/pose_curvature.h"
#include "mrpt_ext/solvers/pose_ml.h"
#include "test_length.h"

namespace mrpt_ext::test_pose_from_landmarks
{
namespace
{
using Kind = PoseMeasurement::Kind;
using What = MeasurementSetup::What;

const Pose2 kRobot{2, 3, 0.8};
const Pose2 kFront{0.4, 0.1, 0.3}, kRear{-0.3, -0.2, 2.9};

PoseMeasurement exact(Kind kind, const Vector2d& landmark, const Pose2& sensor = {}, double std = 0.01)
{
  PoseMeasurement m{kind, landmark, 0, std, sensor};
  m.value = predict(m, kRobot);
  return m;
}

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

bool contains(const IdentifiedPose& solved, const Pose2& pose, double tolerance = 1e-6)
{
  return std::any_of(solved.candidates.begin(), solved.candidates.end(),
                     [&](const PoseCandidate& c)
                     {
                       return distance(c.pose.mean, pose) < tolerance &&
                              (!c.heading_known || std::abs(wrap(c.pose.mean.phi - pose.phi)) < tolerance);
                     });
}

/// Sure of a pose, and the truth among the candidates.
void expectFound(const std::vector<PoseMeasurement>& measurements)
{
  const IdentifiedPose solved = solvePoseFromLandmarks(measurements);
  EXPECT_EQ(solved.status, SolveStatus::ok) << toString(solved.status);
  EXPECT_TRUE(contains(solved, kRobot));
}
}  // namespace

TEST(IdentifiedPose, EveryMixOfKindsAndSensorsGivesThePose)
{
  const Vector2d a(8, 1), b(1, 9), c(-4, 2), d(6, 8);
  expectFound({exact(Kind::bearing, a), exact(Kind::bearing, b), exact(Kind::bearing, c)});
  expectFound({exact(Kind::bearing, a, kFront), exact(Kind::bearing, b, kFront), exact(Kind::bearing, c, kFront)});
  expectFound({exact(Kind::bearing, a, kFront), exact(Kind::bearing, b, kRear), exact(Kind::bearing, c, kFront)});
  expectFound({exact(Kind::bearing, a, kFront), exact(Kind::range, a, kFront), exact(Kind::bearing, b, kFront),
               exact(Kind::range, b, kFront)});
  expectFound({exact(Kind::bearing, a, kRear), exact(Kind::range, b, kFront), exact(Kind::range, c),  //
               exact(Kind::range, d)});
  expectFound({exact(Kind::bearing, a, kRear), exact(Kind::bearing, b, kFront), exact(Kind::range, c),  //
               exact(Kind::range, d)});
  expectFound({exact(Kind::heading, {0, 0}), exact(Kind::bearing, a, kRear), exact(Kind::bearing, b, kFront)});
  expectFound({exact(Kind::heading, {0, 0}), exact(Kind::bearing, a), exact(Kind::range, a)});
  expectFound({exact(Kind::heading, {0, 0}), exact(Kind::range, a), exact(Kind::range, b), exact(Kind::range, c)});
}

TEST(IdentifiedPose, RangesOfSensorsInDifferentPlacesTellTheHeading)
{
  std::vector<PoseMeasurement> ranges;
  for (const Vector2d& l : {Vector2d(8, 1), Vector2d(1, 9), Vector2d(-4, 2)})
    for (const Pose2& place : {Pose2{1, 0, 0}, Pose2{-1, 0, 0}}) ranges.push_back(exact(Kind::range, l, place));
  expectFound(ranges);
  EXPECT_TRUE(solvePoseFromLandmarks(ranges).candidates.front().heading_known);
}

TEST(IdentifiedPose, TwoRangesGiveBothMirrorPlacesWithoutHeading)
{
  const IdentifiedPose solved =
      solvePoseFromLandmarks(std::vector<PoseMeasurement>{exact(Kind::range, {0, 0}), exact(Kind::range, {6, 0})});
  EXPECT_EQ(solved.status, SolveStatus::ok);
  ASSERT_EQ(solved.candidates.size(), 2u);
  EXPECT_FALSE(solved.unique());
  EXPECT_TRUE(contains(solved, {2, 3, 0}));
  EXPECT_TRUE(contains(solved, {2, -3, 0}));
  for (const PoseCandidate& c : solved.candidates)
  {
    EXPECT_FALSE(c.heading_known);
    EXPECT_NEAR(c.pose.covariance(2, 2), kPi * kPi / 3, 1e-9);
    EXPECT_NEAR(c.probability, 0.5, 1e-6);
  }
}

TEST(IdentifiedPose, OneRangeBesideTwoBearingsLeavesTwoPlacesWhenBothFit)
{
  // On the circle through both landmarks and the robot, two places are equally far from the third.
  const std::vector<PoseMeasurement> measurements = {exact(Kind::bearing, {8, 1}), exact(Kind::bearing, {1, 9}),
                                                     exact(Kind::range, {8, 1})};
  const IdentifiedPose solved = solvePoseFromLandmarks(measurements);
  EXPECT_TRUE(contains(solved, kRobot));
  for (const PoseCandidate& c : solved.candidates) EXPECT_LT(c.chi2, 1e-9);
}

TEST(IdentifiedPose, ContradictionsAreNamed)
{
  std::vector<PoseMeasurement> measurements;
  for (const Vector2d& l : {Vector2d(8, 1), Vector2d(1, 9), Vector2d(-4, 2), Vector2d(3, -5), Vector2d(6, 8)})
    measurements.push_back(exact(Kind::bearing, l));
  EXPECT_EQ(solvePoseFromLandmarks(measurements).status, SolveStatus::ok);
  EXPECT_GT(solvePoseFromLandmarks(measurements).consistency, 0.99);
  measurements[2].value += 0.3;  // thirty standard deviations
  const IdentifiedPose solved = solvePoseFromLandmarks(measurements);
  EXPECT_EQ(solved.status, SolveStatus::none);
  EXPECT_LT(solved.consistency, 1e-6);
  EXPECT_FALSE(solved.candidates.empty()) << "for those who know better";
}

TEST(IdentifiedPose, DegenerateGeometryIsNamed)
{
  // Robot and landmarks on one circle; then nearly so.
  std::vector<PoseMeasurement> on_circle, near_circle;
  for (const double angle : {0.3, 1.4, 2.9, 4.0})
  {
    on_circle.push_back(exact(Kind::bearing, kRobot.position() + 5 * (direction(angle) - direction(5.0))));
    near_circle.push_back(
        exact(Kind::bearing, kRobot.position() + (5 + 0.02 * angle) * direction(angle) - 5 * direction(5.0)));
  }
  EXPECT_EQ(solvePoseFromLandmarks(on_circle).status, SolveStatus::degenerate);
  EXPECT_EQ(solvePoseFromLandmarks(near_circle).status, SolveStatus::degenerate);
  // In line with all landmarks.
  std::vector<PoseMeasurement> in_line;
  for (const double along : {-4.0, 3.0, 6.0, 9.0})
    in_line.push_back(exact(Kind::bearing, kRobot.position() + along * direction(0.4)));
  EXPECT_EQ(solvePoseFromLandmarks(in_line).status, SolveStatus::degenerate);
  // Repeating one landmark adds nothing.
  EXPECT_EQ(solvePoseFromLandmarks(std::vector<PoseMeasurement>(3, exact(Kind::bearing, {8, 1}))).status,
            SolveStatus::degenerate);
}

TEST(IdentifiedPose, TooFewAndBadInput)
{
  const std::vector<PoseMeasurement> two = {exact(Kind::bearing, {8, 1}), exact(Kind::range, {8, 1})};
  EXPECT_EQ(solvePoseFromLandmarks(two).status, SolveStatus::too_few);
  EXPECT_EQ(solvePoseFromLandmarks({}).status, SolveStatus::too_few);
  EXPECT_EQ(solvePoseFromLandmarks(std::vector<PoseMeasurement>{exact(Kind::range, {8, 1})}).status,
            SolveStatus::too_few);
  std::vector<PoseMeasurement> bad(4, exact(Kind::range, {8, 1}));
  bad[2].std = 0;
  EXPECT_EQ(solvePoseFromLandmarks(bad).status, SolveStatus::bad_input);
}

TEST(IdentifiedPose, LandmarksSeenAgainAndAgainHideNoOther)
{
  // In turn, so that an even choice among the readings would see but one of them.
  std::vector<PoseMeasurement> bearings, ranges;
  for (int k = 0; k < 5; ++k)
    for (const Vector2d& l : {Vector2d(8, 1), Vector2d(1, 9), Vector2d(-4, 2), Vector2d(6, 8)})
    {
      bearings.push_back(exact(Kind::bearing, l, {0.1 * k, 0, 0}));
      ranges.push_back(exact(Kind::range, l));
    }
  expectFound(bearings);
  EXPECT_TRUE(contains(solvePoseFromLandmarks(ranges), kRobot));
}

TEST(IdentifiedPose, LargeMapCoordinatesCostNothing)
{
  const Vector2d far(4.5e5, 5.4e6);
  std::vector<PoseMeasurement> near_origin, shifted;
  RandomStream random(41);
  const Scene scene = randomScene(random, 6);
  near_origin = shifted = measureScene(scene, {What::mixed, 0.01, 0.05}, random);
  for (PoseMeasurement& m : shifted) m.landmark += far;
  const Pose2 a = solvePoseFromLandmarks(near_origin).candidates.at(0).pose.mean;
  const Pose2 b = solvePoseFromLandmarks(shifted).candidates.at(0).pose.mean;
  EXPECT_LT((b.position() - far - a.position()).norm(), 1e-6);
}

TEST(IdentifiedPose, FindsTheMinimumThatStartsAtTheTruth)
{
  int worse = 0;
  for (const What what : {What::bearings, What::ranges_and_bearings, What::mixed})
    for (const int landmarks : {4, 6, 15})
    {
      RandomStream random(42, static_cast<std::uint64_t>(landmarks));
      for (int trial = 0; trial < testing::runsOfTest(700); ++trial)
      {
        const Scene scene = randomScene(random, landmarks);
        const auto measurements = measureScene(scene, {what, degToRad(0.5), 0.1}, random);
        const PoseMl from_truth = refinePose(measurements, scene.robot);
        const IdentifiedPose solved = solvePoseFromLandmarks(measurements);
        if (from_truth.status != SolveStatus::ok) continue;
        worse += solved.candidates.empty() || solved.candidates.front().chi2 > from_truth.chi2 + 1e-6;
      }
    }
  EXPECT_LE(worse, 6) << "of 6300";
}

TEST(IdentifiedPose, ReachesTheCramerRaoBoundOrSaysThatItCannot)
{
  for (const int landmarks : {4, 6, 10, 30})
    for (const double sigma_deg : {0.1, 1.0})
    {
      RandomStream random(43, static_cast<std::uint64_t>(landmarks));
      const CramerRaoTally t = tallyAgainstBound({What::bearings, degToRad(sigma_deg), 0}, landmarks,
                                                 testing::runsOfTest(80), 200, {}, random);
      if (testing::isShort()) continue;  // too few scenes for the bounds
      EXPECT_LE(t.quantile(0.5), 1.05) << landmarks << " landmarks, " << sigma_deg << " deg";
      EXPECT_LE(t.quantile(0.9), 1.25);
      EXPECT_GE(t.quantile(0.5), 0.95) << "better than the bound is a wrong comparison";
      EXPECT_EQ(t.flagged_other, t.other_scenes);
      EXPECT_LE(t.flagged_good, landmarks > 4 ? 6 : 16);
      EXPECT_EQ(t.contradictory, 0);
    }
}

TEST(IdentifiedPose, TheOtherKindsReachTheirBounds)
{
  for (const What what : {What::ranges, What::ranges_and_bearings, What::mixed})
    for (const int landmarks : {4, 10})
    {
      RandomStream random(44, static_cast<std::uint64_t>(landmarks));
      const CramerRaoTally t =
          tallyAgainstBound({what, degToRad(0.3), 0.05}, landmarks, testing::runsOfTest(60), 100, {}, random);
      if (testing::isShort()) continue;  // too few scenes for the bounds
      EXPECT_NEAR(t.quantile(0.5), 1, 0.05);
      EXPECT_LE(t.quantile(0.9), 1.25);
      EXPECT_EQ(t.flagged_other, t.other_scenes);
    }
}

TEST(IdentifiedPose, NeverConfidentAndWrong)
{
  for (const What what : {What::bearings, What::ranges, What::ranges_and_bearings, What::mixed})
  {
    TrustTally tally;
    RandomStream random(45, static_cast<std::uint64_t>(what));
    for (int trial = 0; trial < testing::runsOfTest(6000); ++trial)
    {
      const Scene scene = randomScene(random, 4 + trial % 9);
      const double scale = trial % 2 ? 1 : 0.1;
      const MeasurementSetup kind{what, degToRad(scale), 0.3 * scale};
      tallyTrust(tally, scene, solvePoseFromLandmarks(measureScene(scene, kind, random)));
    }
    EXPECT_EQ(tally.confident_wrong, 0);
    EXPECT_EQ(tally.far_off, 0);
    EXPECT_GT(tally.unique, testing::runsOfTest(5000));
    if (testing::isShort()) continue;  // too few trials for the bound
    const double freedoms = what == What::ranges ? 2 : 3;
    EXPECT_NEAR(tally.mean_nees, freedoms, 0.15) << "the covariance is honest";
  }
}

TEST(PoseCurvature, SecondMomentIsTheScatterBeyondTheLinearError)
{
  // A long bent valley: robot and landmarks nearly on a circle.
  Scene scene{{{0, 0}, {8, 1}, {7.5, 8}, {0.5, 7}}, {4.2, -1.3, 0.4}};
  const double sigma = degToRad(0.5);
  RandomStream random(46);
  const std::vector<PoseMeasurement> noiseless = measureScene(scene, {What::bearings, sigma, 0}, random);
  const Matrix3d P = *covarianceFromInformation(poseInformation(noiseless, scene.robot));
  const PoseCurvature curvature = poseCurvature(PoseResiduals(noiseless), scene.robot, P);
  Matrix3d scatter = Matrix3d::Zero();
  const int trials = 20000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const PoseMl ml = refinePose(measureScene(scene, {What::bearings, sigma, 0}, random), scene.robot);
    Vector3d e = ml.pose.mean.vector() - scene.robot.vector();
    e.z() = wrap(e.z());
    scatter += e * e.transpose() / trials;
  }
  // Mean squares in standard deviations of the linear error: 3 without curvature.
  const double linear = (P.inverse() * scatter).trace();
  const double bent = ((P + curvature.second_moment).inverse() * scatter).trace();
  EXPECT_GT(curvature.rms, 0.3);
  EXPECT_GT(linear, 3.1);
  EXPECT_NEAR(bent, 3, 0.1);
  EXPECT_NEAR(curvature.weakest.dot(P.inverse() * curvature.weakest), 1, 1e-9);
}
}  // namespace mrpt_ext::test_pose_from_landmarks
