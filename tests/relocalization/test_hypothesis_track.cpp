#include "mrpt_ext/relocalization/hypothesis_track.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_hypothesis_track
{
namespace
{
const LandmarkTable kPosts({{.id = 1, .position = {4, 0, 0}}, {.id = 2, .position = {0, 5, 0}}});
const LandmarkIndex kMap(kPosts);
constexpr double kStd = degToRad(1.0), kGate = 3.3;
const SensorModel kSensor{.max_range = 10, .clutter_probability = 0.1};

/// Bearings without noise to both landmarks from `robot`, then one to nothing.
std::vector<Scan> scansFrom(const Pose2& robot)
{
  Scan scan{{}, kSensor, {}};
  for (const Vector2d& post : {Vector2d(4, 0), Vector2d(0, 5)})
    scan.detections.push_back({.bearing = predictBearing(robot, post), .std_bearing = kStd});
  scan.detections.push_back({.bearing = kPi / 4, .std_bearing = kStd});
  return {scan};
}

HypothesisTrack trackAt(const Pose2& pose, double std_xy = 0.05)
{
  return {{pose, Vector3d(square(std_xy), square(std_xy), square(0.02)).asDiagonal()}, 0};
}
}  // namespace

TEST(HypothesisTrack, PredictThenRetrodictReturnsWithMoreNoise)
{
  HypothesisTrack track{{{1, 2, 0.5}, Matrix3d::Identity() * 0.01}, 0};
  const TrajectoryStep step{{0.3, 0.1, 0.4}, Vector3d(1e-4, 2e-4, 3e-4).asDiagonal(), {}};
  const Matrix3d before = track.pose.covariance;
  predict(track, step);
  retrodict(track, step);
  EXPECT_NEAR(track.pose.mean.x, 1, 1e-12);
  EXPECT_NEAR(track.pose.mean.phi, 0.5, 1e-12);
  EXPECT_GT((track.pose.covariance - before).trace(), 2 * 5.9e-4);  // noise both ways
}

TEST(HypothesisTrack, UpdateAssociatesAndReducesTheResiduals)
{
  const Pose2 truth{1, 1, 0};
  const auto residual = [&](const Pose2& pose, const Vector2d& post)
  { return std::abs(wrap(predictBearing(pose, post) - predictBearing(truth, post))); };
  const HypothesisTrack prior = trackAt({1, 1, 0.03});
  HypothesisTrack track = prior;
  EXPECT_EQ(update(track, kMap, scansFrom(truth), kGate), (std::vector<int>{0, 1, -1}));
  for (const Vector2d& post : {Vector2d(4, 0), Vector2d(0, 5)})
    EXPECT_LT(residual(track.pose.mean, post), 0.7 * residual(prior.pose.mean, post));
  EXPECT_LT(track.pose.covariance.trace(), prior.pose.covariance.trace());
}

TEST(HypothesisTrack, TheRightPoseHasMoreEvidence)
{
  const std::vector<Scan> scans = scansFrom({1, 1, 0});
  HypothesisTrack right = trackAt({1, 1, 0}), wrong = trackAt({2, 3, 1});
  (void)update(right, kMap, scans, kGate);
  EXPECT_EQ(update(wrong, kMap, scans, kGate), (std::vector<int>{-1, -1, -1}));
  EXPECT_GT(right.log_evidence, wrong.log_evidence + 3);
}

TEST(HypothesisTrack, GivenAssociationsServeAPoseTooUncertainForItsOwn)
{
  const std::vector<Scan> scans = scansFrom({1, 1, 0});
  HypothesisTrack track = trackAt({1.2, 0.8, 0.02}, 1.0);
  updateAssociated(track, kMap, scans, std::vector<int>{0, 1, -1});
  EXPECT_LT(std::abs(wrap(predictBearing(track.pose.mean, {4, 0}) - predictBearing({1, 1, 0}, {4, 0}))), 2 * kStd);
  EXPECT_LT(track.pose.covariance.trace(), 2);
}

TEST(HypothesisTrack, ExpectedEvidenceIsThatOfTheTruthOnAverage)
{
  // All landmarks in view, none missed: the evidence of detections one standard deviation off is the expected one.
  Scan scan{{}, {.max_range = 10, .clutter_probability = 1e-5}, {}};
  for (const Vector2d& post : {Vector2d(4, 0), Vector2d(0, 5)})
    scan.detections.push_back({.bearing = wrap(predictBearing({1, 1, 0}, post) + kStd), .std_bearing = kStd});
  HypothesisTrack exact{{{1, 1, 0}, Matrix3d::Identity() * 1e-12}, 0};
  (void)update(exact, kMap, {&scan, 1}, kGate);
  EXPECT_NEAR(exact.log_evidence, expectedEvidence(kMap, {&scan, 1}), 0.01);
}
}  // namespace mrpt_ext::test_hypothesis_track
