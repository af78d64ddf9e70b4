#include "mrpt_ext/hypotheses/propose_poses.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact_scene.h"

namespace mrpt_ext::test_propose_poses
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const ProposalOptions kOptions{.region = {{-3, -3}, {9, 9}}};
const Pose2 kRobot{2.5, 2, 0.7};
const Pose2 kMount{0.2, -0.1, 0.9};
const ExactSensor kBearings{.T_robot_sensor = kMount};
const ExactSensor kRanges{.bearing = false, .range = true};
const ExactSensor kPoints{.range = true, .T_robot_sensor = kMount};
const ExactSensor kAnonymous{.identified = false, .T_robot_sensor = kMount};
const ExactSensor kAnonymousPoints{.range = true, .identified = false, .T_robot_sensor = kMount};

HypothesisSet proposalsFor(std::vector<Reading> readings, const ProposalOptions& options = kOptions)
{
  return proposePoses({.time = 1, .readings = std::move(readings)}, kMap, GlobalPoseSearch(kMap), options);
}

/// Rank of the first hypothesis at the robot's pose; -1: none.
int rankOf(const Pose2& robot, const HypothesisSet& hypotheses, double metres, double radians)
{
  const auto found =
      std::find_if(hypotheses.begin(), hypotheses.end(),
                   [&](const PoseHypothesis& h)
                   { return distance(h.pose.mean, robot) < metres && turned(h.pose.mean, robot) < radians; });
  return found == hypotheses.end() ? -1 : static_cast<int>(found - hypotheses.begin());
}

int rankOfTruth(const HypothesisSet& hypotheses, double metres = 0.02, double radians = 0.01)
{
  return rankOf(kRobot, hypotheses, metres, radians);
}

/// A reading taken at `then`, propagated to the robot at kRobot.
Reading propagated(const Pose2& then, const std::vector<std::size_t>& landmarks, const ExactSensor& sensor)
{
  Reading reading = seenFrom(then, kMap, landmarks, sensor);
  reading.T_robot_sensor = compose(between(kRobot, then), sensor.T_robot_sensor);
  return reading;
}

RunningFixReading fixOf(const Pose2& displacement)
{
  const Pose2 first = compose(kRobot, inverse(displacement));
  RunningFixReading fix{.time = 1, .sensor = "sonar", .id = 2};
  fix.first_range = predictRange(first, {6, 0.5});
  fix.second_range = predictRange(kRobot, {6, 0.5});
  fix.first_std = fix.second_std = 0.02;
  fix.displacement = displacement;
  fix.displacement_covariance = Vector3d(1e-4, 1e-4, 1e-5).asDiagonal();
  return fix;
}
}  // namespace

TEST(ProposePoses, IdentifiedBearings)
{
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2}, kBearings)})), 0);
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kBearings)})), 0);
}

TEST(ProposePoses, IdentifiedPoints)
{
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1}, kPoints)})), 0);
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kPoints)})), 0);
}

TEST(ProposePoses, RangesLeaveTheHeadingUnknown)
{
  const HypothesisSet three = proposalsFor({seenFrom(kRobot, kMap, {0, 2, 3}, kRanges)});
  ASSERT_FALSE(three.empty());
  EXPECT_LT(distance(three[0].pose.mean, kRobot), 0.02);
  EXPECT_FALSE(three[0].heading_known);
  const HypothesisSet two = proposalsFor({seenFrom(kRobot, kMap, {0, 1}, kRanges)});
  EXPECT_TRUE(std::any_of(two.begin(), two.end(),
                          [](const PoseHypothesis& h) { return distance(h.pose.mean, kRobot) < 0.02; }));
}

TEST(ProposePoses, RangesAndOneBearingGiveTheHeading)
{
  Reading bearing = seenFrom(kRobot, kMap, {1}, {});
  EXPECT_GE(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 2, 3}, kRanges), bearing})), 0);
}

TEST(ProposePoses, RangesOfAWindowGiveTheHeading)
{
  const Pose2 second = compose(kRobot, inverse({0.6, 0, 0.3})), first = compose(second, inverse({0.6, 0.1, 0.2}));
  const HypothesisSet found =
      proposalsFor({propagated(first, {0, 1, 2, 3}, kRanges), propagated(second, {0, 1, 2, 3}, kRanges),
                    propagated(kRobot, {0, 1, 2, 3}, kRanges)});
  const int rank = rankOfTruth(found, 0.05, 0.05);
  ASSERT_EQ(rank, 0);
  EXPECT_TRUE(found[0].heading_known);
}

TEST(ProposePoses, OneLandmarkGivesARing)
{
  const HypothesisSet ring = proposalsFor({seenFrom(kRobot, kMap, {0}, kPoints)}, {.region = {{-20, -20}, {20, 20}}});
  EXPECT_EQ(ring.size(), 36u);
  const double spacing = kTwoPi / 36;
  EXPECT_GE(rankOfTruth(ring, 0.51 * spacing * kRobot.position().norm(), 0.51 * spacing), 0);
  for (const PoseHypothesis& h : ring)
    EXPECT_NEAR(predictRange(h.pose.mean, {0, 0}, kMount), predictRange(kRobot, {0, 0}, kMount), 1e-9);
}

namespace
{
/// The landmark of id 1, of which the map knows that it faces 2.2 rad, seen from kRobot; with its direction.
Reading facingReading(double std, double other_weight = 0)
{
  Reading reading = seenFrom(kRobot, kMap, {0}, kPoints);
  const double yaw = wrap(2.2 - kRobot.phi - kMount.phi);
  reading.detections[0].facing = Facing::either({yaw, std}, {yaw + 0.9, std}, other_weight);
  return reading;
}

HypothesisSet facingProposals(const Reading& reading)
{
  std::vector<Landmark> landmarks = kMap.all();
  landmarks[0].yaw = 2.2;
  const LandmarkTable map(landmarks);
  return proposePoses({.time = 1, .readings = {reading}}, map, GlobalPoseSearch(map),
                      {.region = {{-20, -20}, {20, 20}}});
}
}  // namespace

TEST(ProposePoses, OneLandmarkThatFacesAKnownDirectionGivesAPose)
{
  const HypothesisSet found = facingProposals(facingReading(0.05));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(rankOfTruth(found), 0);
  EXPECT_EQ(found[0].source, "oriented_landmark");
  EXPECT_NEAR(found[0].pose.covariance(2, 2), square(0.05), 1e-6);
  // Turned about the landmark, 3.2 m away.
  const double across = found[0].pose.covariance.topLeftCorner<2, 2>().trace();
  EXPECT_NEAR(std::sqrt(across), 0.05 * kRobot.position().norm(), 0.03);
}

TEST(ProposePoses, TwoAttitudesGiveTwoPoses)
{
  const HypothesisSet found = facingProposals(facingReading(0.05, 0.3));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(rankOfTruth(found), 0);
  EXPECT_NEAR(wrap(found[0].pose.mean.phi - found[1].pose.mean.phi), 0.9, 0.01);
  EXPECT_NEAR(found[1].weight, 0.3, 0.02);
}

TEST(ProposePoses, ARunningFixWithACompass)
{
  Frame frame{.time = 1, .fixes = {fixOf({1.2, 0.2, 0.4})}};
  frame.compass = CompassRecord{1, "compass", kRobot.phi, degToRad(1)};
  const HypothesisSet found = proposePoses(frame, kMap, GlobalPoseSearch(kMap), {.region = {{-20, -20}, {20, 20}}});
  EXPECT_EQ(found.size(), 2u);
  EXPECT_GE(rankOfTruth(found), 0);
}

TEST(ProposePoses, ARunningFixWithoutACompass)
{
  const Frame frame{.time = 1, .fixes = {fixOf({1.2, 0.2, 0.4})}};
  const HypothesisSet found = proposePoses(frame, kMap, GlobalPoseSearch(kMap), {.region = {{-20, -20}, {20, 20}}});
  const double spacing = kTwoPi / 36;
  EXPECT_GE(rankOfTruth(found, spacing * distance(kRobot, {6, 0.5, 0}), 0.51 * spacing), 0);
  EXPECT_GT(found.size(), 36u);  // mirror images
}

TEST(ProposePoses, AnonymousBearings)
{
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kAnonymous)})), 0);
  EXPECT_GE(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2, 3}, kAnonymous)})), 0);
  EXPECT_GE(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2}, kAnonymous)})), 0);
}

TEST(ProposePoses, AnonymousPoints)
{
  EXPECT_EQ(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2, 3}, kAnonymousPoints)})), 0);
  EXPECT_GE(rankOfTruth(proposalsFor({seenFrom(kRobot, kMap, {1, 3}, kAnonymousPoints)})), 0);
}

TEST(ProposePoses, TheTruthIsAmongThemFromEverywhere)
{
  RandomStream random(4);
  const PoseRegion inner{{-2, -2}, {8, 8}};
  for (int k = 0; k < 60; ++k)
  {
    const Pose2 robot = inner.sample(random);
    for (const ExactSensor& sensor : {kBearings, kPoints, kAnonymous, kAnonymousPoints})
    {
      const HypothesisSet found = proposalsFor({seenFrom(robot, kMap, {0, 1, 2, 3, 4}, sensor)});
      EXPECT_GE(rankOf(robot, found, 0.05, 0.05), 0)
          << robot.vector().transpose() << " identified " << sensor.identified << " range " << sensor.range;
    }
  }
}

TEST(ProposePoses, OutliersAreTolerated)
{
  Reading bearings = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kBearings);
  bearings.detections[1].bearing = wrap(*bearings.detections[1].bearing + 1);
  EXPECT_EQ(rankOfTruth(proposalsFor({bearings}), 0.05, 0.02), 0);

  Reading points = seenFrom(kRobot, kMap, {0, 1, 2}, kPoints);
  *points.detections[0].range += 2;
  EXPECT_EQ(rankOfTruth(proposalsFor({points}), 0.05, 0.02), 0);

  Reading ranges = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kRanges);
  *ranges.detections[3].range += 1.5;
  EXPECT_LT(distance(proposalsFor({ranges})[0].pose.mean, kRobot), 0.05);

  Reading anonymous = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kAnonymous);
  anonymous.detections[2].bearing = wrap(*anonymous.detections[2].bearing + 0.8);
  EXPECT_GE(rankOfTruth(proposalsFor({anonymous}), 0.05, 0.02), 0);

  Reading anonymous_points = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kAnonymousPoints);
  *anonymous_points.detections[2].range += 2;
  EXPECT_EQ(rankOfTruth(proposalsFor({anonymous_points}), 0.05, 0.02), 0);
}

TEST(ProposePoses, AreRankedNormalisedAndInTheRegion)
{
  const HypothesisSet found = proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2}, kAnonymous)});
  ASSERT_GT(found.size(), 3u);
  double sum = 0;
  for (const PoseHypothesis& h : found)
  {
    EXPECT_TRUE(kOptions.region.contains(h.pose.mean));
    EXPECT_LE(h.log_score, found.front().log_score);
    EXPECT_FALSE(h.source.empty());
    sum += h.weight;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
  ProposalOptions few = kOptions;
  few.max_hypotheses = 3;
  const HypothesisSet best = proposalsFor({seenFrom(kRobot, kMap, {0, 1, 2}, kAnonymous)}, few);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0].pose.mean.vector(), found[0].pose.mean.vector());
  EXPECT_NEAR(best[0].weight + best[1].weight + best[2].weight, 1, 1e-9);
}

TEST(ProposePoses, ManyReadingsInTheWindowAreAffordable)
{
  // 1500 bearings and their 400 million triples, which would not fit into memory.
  const std::vector<Reading> readings(300, seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kBearings));
  EXPECT_EQ(rankOfTruth(proposalsFor(readings)), 0);
}

TEST(ProposePoses, NothingToProposeFrom)
{
  EXPECT_TRUE(proposalsFor({}).empty());
  EXPECT_TRUE(proposalsFor({seenFrom(kRobot, kMap, {0}, kRanges)}).empty());
  EXPECT_TRUE(
      proposePoses({.readings = {seenFrom(kRobot, kMap, {0, 1, 2, 3}, kAnonymous)}}, {}, GlobalPoseSearch({}), kOptions)
          .empty());
}
}  // namespace mrpt_ext::test_propose_poses
