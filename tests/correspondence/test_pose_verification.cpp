#include "mrpt_ext/correspondence/pose_verification.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_pose_verification
{
namespace
{
constexpr double kLogZero = -std::numeric_limits<double>::infinity();

/// Twelve landmarks, and a sensor that sees those within 8 m.
class PoseJudge : public ::testing::Test
{
 protected:
  PoseJudge()
  {
    for (int i = 0; i < 12; ++i) landmarks_.emplace_back(random_.uniform(0, 10), random_.uniform(0, 10));
    scan_.model.max_range = 8;
    scan_.model.detection_probability = 0.7;
    scan_.model.clutter_probability = 0.05;
    for (const Vector2d& landmark : landmarks_)
      if (predictRange(truth_, landmark) <= 8)
        scan_.detections.push_back(
            {.bearing = wrap(predictBearing(truth_, landmark) + 0.002 * random_.gaussian()), .std_bearing = 0.002});
  }

  [[nodiscard]] std::optional<ConsistentPose> judge(const Pose2& start, int least = 5) const
  {
    const GaussianPose candidate{start, Vector3d(0.01, 0.01, 1e-4).asDiagonal()};
    return verifyPose(LandmarkIndex(landmarks_), {&scan_, 1}, {}, candidate, least);
  }

  RandomStream random_{3};
  std::vector<Vector2d> landmarks_;
  Scan scan_;
  Pose2 truth_{4, 5, 1};
};

TEST_F(PoseJudge, RefinesAndMatchesAll)
{
  const auto verified = judge({4.1, 4.95, 1.01});
  ASSERT_TRUE(verified);
  EXPECT_EQ(verified->matched, static_cast<int>(scan_.detections.size()));
  const Vector3d e = verified->pose.mean.vector() - truth_.vector();
  EXPECT_LT(e.dot(verified->pose.covariance.inverse() * e), 16);
}

TEST_F(PoseJudge, AFalseDetectionStaysUnmatchedAndCosts)
{
  const auto before = judge(truth_);
  scan_.detections.push_back({.bearing = *scan_.detections[0].bearing + 0.05, .std_bearing = 0.002});
  const auto after = judge(truth_);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->matched, before->matched);
  EXPECT_EQ(after->assignment.back(), -1);
  EXPECT_LT(after->log_likelihood, before->log_likelihood - 2);
}

TEST_F(PoseJudge, AMissedLandmarkCostsTheOddsOfMissingIt)
{
  const auto before = judge(truth_);
  scan_.detections.pop_back();
  const auto after = judge(truth_);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->matched, before->matched - 1);
  EXPECT_LT(after->log_likelihood, before->log_likelihood);
}

TEST_F(PoseJudge, NoLandmarkIsMatchedTwice)
{
  AnonymousDetection again = scan_.detections[0];
  *again.bearing += 0.001;
  scan_.detections.push_back(again);
  const auto verified = judge(truth_);
  ASSERT_TRUE(verified);
  std::vector<int> matched;
  for (const int landmark : verified->assignment)
    if (landmark >= 0) matched.push_back(landmark);
  std::sort(matched.begin(), matched.end());
  EXPECT_EQ(std::unique(matched.begin(), matched.end()), matched.end());
}

TEST_F(PoseJudge, TooFewMatchesOrOutsideTheAreaIsNoPose)
{
  EXPECT_FALSE(judge({8, 1, -2}));
  PoseSearchOptions options;
  options.area = Box2{{6, 0}, {10, 10}};
  const GaussianPose candidate{truth_, Vector3d(0.01, 0.01, 1e-4).asDiagonal()};
  EXPECT_FALSE(verifyPose(LandmarkIndex(landmarks_), {&scan_, 1}, options, candidate, 4));
}

TEST_F(PoseJudge, SpendsWhatItDoesAndEndsWithTheBudget)
{
  const GaussianPose candidate{truth_, Vector3d(0.01, 0.01, 1e-4).asDiagonal()};
  const LandmarkIndex map(landmarks_);
  WorkBudget much(1'000'000), little(1000);
  PoseSearchOptions options;
  options.budget = &much;
  EXPECT_TRUE(verifyPose(map, {&scan_, 1}, options, candidate, 4));
  EXPECT_GT(much.spent(), 1000U);
  options.budget = &little;
  EXPECT_FALSE(verifyPose(map, {&scan_, 1}, options, candidate, 4));
}

TEST_F(PoseJudge, LikelihoodIsFiniteForEveryModel)
{
  for (const double clutter : {0.0, 0.5, 1.0})
    for (const std::optional<double> detection : {std::optional<double>(), std::optional<double>(1.0)})
    {
      scan_.model.clutter_probability = clutter;
      scan_.model.detection_probability = detection;
      const auto verified = judge(truth_);
      ASSERT_TRUE(verified);
      EXPECT_TRUE(std::isfinite(verified->log_evidence));
    }
}

TEST_F(PoseJudge, RangesAreJudgedToo)
{
  for (AnonymousDetection& z : scan_.detections)
  {
    z.range = 3;
    z.std_range = 0.01;
  }
  EXPECT_FALSE(judge(truth_));
}

/// Evidence by brute-force integration over the pose agrees with the Laplace approximation.
TEST_F(PoseJudge, EvidenceIsTheIntegralOfTheLikelihood)
{
  const auto verified = judge(truth_);
  ASSERT_TRUE(verified);
  double sum = 0;
  constexpr int kSamples = 4000;
  const Matrix3d cholesky = verified->pose.covariance.llt().matrixL();
  const LandmarkIndex map(landmarks_);
  std::vector<AnonymousDetection> detections = scan_.detections;
  for (int i = 0; i < kSamples; ++i)
  {
    const Vector3d unit(random_.gaussian(), random_.gaussian(), random_.gaussian());
    const Vector3d at = verified->pose.mean.vector() + cholesky * unit;
    double log_ratio = 0.5 * unit.squaredNorm();  // of likelihood and sampling density, up to constants
    for (std::size_t d = 0; d < detections.size(); ++d)
    {
      const int l = verified->assignment[d];
      const Vector2d& landmark = landmarks_[static_cast<std::size_t>(l)];
      const double there = predictBearing({at.x(), at.y(), at.z()}, landmark);
      const double best = predictBearing(verified->pose.mean, landmark);
      log_ratio -= 0.5 * (square(wrap(*detections[d].bearing - there)) - square(wrap(*detections[d].bearing - best))) /
                   square(0.002);
    }
    sum += std::exp(log_ratio) / kSamples;
  }
  EXPECT_NEAR(std::log(sum), 0, 0.1);
  EXPECT_NEAR(verified->log_evidence - verified->log_likelihood,
              0.5 * (3 * std::log(kTwoPi) + std::log(verified->pose.covariance.determinant())), 1e-9);
}

ConsistentPose poseAt(double x, double log_evidence)
{
  ConsistentPose pose;
  pose.pose = {{x, 0, 0}, Vector3d(1e-4, 1e-4, 1e-6).asDiagonal()};
  pose.log_evidence = pose.log_likelihood = log_evidence;
  pose.assignment = {static_cast<int>(1000 * x)};
  return pose;
}

TEST(RankPoses, NormalisesJoinsAndCuts)
{
  PoseSearchResult search;
  search.poses = {poseAt(1, -20), poseAt(5, -10), poseAt(5.001, -10.5), poseAt(9, -10)};
  rankPoses(search, {.keep_log_units = 8}, kLogZero);
  EXPECT_EQ(search.status, SolveStatus::ok);
  ASSERT_EQ(search.poses.size(), 2u);
  EXPECT_NEAR(search.poses[0].probability, 0.5, 1e-12);
  EXPECT_FALSE(search.unique);
}

TEST(RankPoses, EvidenceNotSearchedLowersTheProbability)
{
  PoseSearchResult search;
  search.poses = {poseAt(1, -3)};
  rankPoses(search, {}, -3);
  EXPECT_NEAR(search.poses[0].probability, 0.5, 1e-12);
  EXPECT_NEAR(search.probability_elsewhere, 0.5, 1e-12);
}

TEST(RankPoses, UniqueOnlyWhenChanceHardlyMakesSuchPoses)
{
  PoseSearchResult search;
  search.poses = {poseAt(1, -3)};
  search.expected_false = 0.01;
  rankPoses(search, {}, kLogZero);
  EXPECT_TRUE(search.unique);
  search.expected_false = 0.1;
  rankPoses(search, {}, kLogZero);
  EXPECT_FALSE(search.unique);
}

// Where most of one is not explained but its area is large, and the other the reverse, each is far below the other.
TEST(RankPoses, TheMostEvidentPoseStaysHoweverUnlikelyItIs)
{
  PoseSearchResult search;
  search.poses = {poseAt(1, -20), poseAt(5, 0)};
  search.poses[0].log_likelihood = 0;
  search.poses[1].log_likelihood = -20;
  rankPoses(search, {.keep_log_units = 8}, kLogZero);
  ASSERT_EQ(search.poses.size(), 1u);
  EXPECT_EQ(search.poses[0].pose.mean.x, 5);
  EXPECT_NEAR(search.poses[0].probability, 1, 1e-12);
}

TEST(RankPoses, NothingFound)
{
  PoseSearchResult search;
  rankPoses(search, {}, kLogZero);
  EXPECT_EQ(search.status, SolveStatus::none);
  EXPECT_EQ(search.probability_elsewhere, 1);
}
}  // namespace
}  // namespace mrpt_ext::test_pose_verification
