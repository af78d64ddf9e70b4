#include "mrpt_ext/hypotheses/propose_from_association.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "exact_scene.h"
#include "mrpt_ext/geometry/random.h"
#include "test_length.h"

namespace mrpt_ext::test_propose_from_association
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const GlobalPoseSearch kSearch(kMap);
const PoseRegion kRegion{{-3, -3}, {9, 9}};
const Pose2 kRobot{2.5, 2, 0.7};
const ExactSensor kEye{.identified = false, .T_robot_sensor = {0.4, 0.3, -1.2}};

AssociationProposals propose(const std::vector<Reading>& readings)
{
  return proposeFromAssociation(readings, kMap, kSearch, kRegion);
}

HypothesisSet threeBearings(const std::vector<Reading>& readings)
{
  return proposeFromThreeBearings(readings, kMap, kSearch, kRegion);
}

bool holdsTruth(const HypothesisSet& found, const Pose2& robot = kRobot)
{
  return std::any_of(found.begin(), found.end(),
                     [&](const PoseHypothesis& h)
                     { return distance(h.pose.mean, robot) < 0.01 && turned(h.pose.mean, robot) < 0.01; });
}
}  // namespace

TEST(ProposeFromAssociation, PosesAreThoseOfTheRobotNotOfTheSensor)
{
  const auto found = propose({seenFrom(kRobot, kMap, {3, 1, 0, 2, 4}, kEye)});
  EXPECT_EQ(found.status, SolveStatus::ok);
  ASSERT_FALSE(found.hypotheses.empty());
  EXPECT_LT(distance(found.hypotheses[0].pose.mean, kRobot), 1e-4);
}

TEST(ProposeFromAssociation, TheCovarianceIsThatOfTheRobotToo)
{
  RandomStream random(2);
  Matrix3d sampled = Matrix3d::Zero(), stated = Matrix3d::Zero();
  const int count = testing::runsOfTest(2000);
  for (int k = 0; k < count; ++k)
  {
    Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
    for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
    const auto found = propose({reading});
    const auto truth = std::min_element(found.hypotheses.begin(), found.hypotheses.end(),
                                        [](const auto& a, const auto& b)
                                        { return distance(a.pose.mean, kRobot) < distance(b.pose.mean, kRobot); });
    ASSERT_NE(truth, found.hypotheses.end());
    const Pose2& m = truth->pose.mean;
    const Vector3d d(m.x - kRobot.x, m.y - kRobot.y, wrap(m.phi - kRobot.phi));
    sampled += d * d.transpose() / count;
    stated += truth->pose.covariance / count;
  }
  if (testing::isShort()) return;  // too few trials for the bounds
  EXPECT_LT((sampled - stated).norm(), 0.15 * stated.norm()) << sampled << "\n\n" << stated;
}

TEST(ProposeFromAssociation, NothingToAssociateIsTooFew)
{
  EXPECT_EQ(propose({}).status, SolveStatus::too_few);
  ExactSensor identified = kEye;
  identified.identified = true;
  EXPECT_EQ(propose({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, identified)}).status, SolveStatus::too_few);
}

TEST(ProposeFromAssociation, OneOfFiveMayBeClutter)
{
  const Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  for (std::size_t wrong = 0; wrong < 5; ++wrong)
  {
    Reading spoilt = reading;
    spoilt.detections[wrong].bearing = wrap(*spoilt.detections[wrong].bearing + 0.5);
    EXPECT_TRUE(holdsTruth(propose({spoilt}).hypotheses)) << wrong;
  }
}

TEST(ProposeFromAssociation, ACategoryThatNoLandmarkHasIsClutter)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  reading.detections.insert(reading.detections.begin(),
                            {.category = "unicorn", .bearing = 0.4, .std_bearing = kEye.std_bearing});
  EXPECT_TRUE(holdsTruth(propose({reading}).hypotheses));
}

TEST(ProposeFromAssociation, ReadingsOfAllSensorsAreSearchedJointly)
{
  ExactSensor other = kEye;
  other.T_robot_sensor = {-0.5, 0, 2};
  const Reading front = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kEye), back = seenFrom(kRobot, kMap, {4, 1}, other);
  const auto alone = propose({front}), together = propose({front, back});
  ASSERT_FALSE(together.hypotheses.empty());
  EXPECT_LT(distance(together.hypotheses[0].pose.mean, kRobot), 1e-4);
  ASSERT_FALSE(alone.hypotheses.empty());
  EXPECT_LT(together.hypotheses[0].pose.covariance.determinant(), alone.hypotheses[0].pose.covariance.determinant());
}

TEST(ProposeFromAssociation, PointsAreMatchedAsAConstellation)
{
  ExactSensor ranger = kEye;
  ranger.range = true;
  const auto two = propose({seenFrom(kRobot, kMap, {0, 2}, ranger)});
  EXPECT_TRUE(holdsTruth(two.hypotheses));
  const auto four = propose({seenFrom(kRobot, kMap, {0, 2, 3, 4}, ranger)});
  ASSERT_FALSE(four.hypotheses.empty());
  EXPECT_LT(distance(four.hypotheses[0].pose.mean, kRobot), 1e-4);
}

TEST(ProposeFromAssociation, ManyBearings)
{
  std::vector<Landmark> landmarks;
  RandomStream random(9);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < 25; ++i)
  {
    landmarks.push_back({.position = {random.uniform(-3, 9), random.uniform(-3, 9), 0}});
    all.push_back(i);
  }
  const LandmarkTable map(landmarks);
  const std::vector readings{seenFrom(kRobot, map, all, kEye)};
  const auto found = proposeFromAssociation(readings, map, GlobalPoseSearch(map), kRegion);
  ASSERT_FALSE(found.hypotheses.empty());
  EXPECT_LT(distance(found.hypotheses[0].pose.mean, kRobot), 0.01);
  EXPECT_TRUE(found.unique);
}

TEST(ProposeFromAssociation, OutsideTheRegionIsNoSolution)
{
  const std::vector readings{seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye)};
  const auto found = proposeFromAssociation(readings, kMap, kSearch, {{-3, -3}, {-2, -2}});
  EXPECT_EQ(found.status, SolveStatus::none);
  EXPECT_TRUE(found.hypotheses.empty());
}

TEST(ProposeFromThreeBearings, ManyPosesNoneVerified)
{
  const HypothesisSet found = threeBearings({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)});
  EXPECT_TRUE(holdsTruth(found));
  EXPECT_GT(found.size(), 1u);
  EXPECT_TRUE(threeBearings({seenFrom(kRobot, kMap, {0, 1}, kEye)}).empty());
  EXPECT_TRUE(threeBearings({}).empty());
  EXPECT_TRUE(threeBearings({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye)}).empty());
}

TEST(ProposeFromThreeBearings, OneOfFourMayBeClutter)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kEye);
  reading.detections[1].bearing = wrap(*reading.detections[1].bearing + 0.5);
  EXPECT_TRUE(holdsTruth(threeBearings({reading})));
}

TEST(ProposeFromThreeBearings, CategoriesReduceTheProposals)
{
  ExactSensor coloured = kEye;
  coloured.category = true;
  const auto plain = threeBearings({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)});
  const auto narrowed = threeBearings({seenFrom(kRobot, kMap, {0, 1, 2}, coloured)});
  EXPECT_TRUE(holdsTruth(narrowed));
  EXPECT_LT(narrowed.size(), plain.size());
}

TEST(ProposeFromThreeBearings, UsesTheScanWithMostBearings)
{
  ExactSensor other = kEye;
  other.T_robot_sensor = {-0.5, 0, 2};
  const Reading few = seenFrom({8, 8, 3}, kMap, {0, 1}, other), many = seenFrom(kRobot, kMap, {0, 1, 2}, kEye);
  EXPECT_TRUE(holdsTruth(threeBearings({few, many})));
  EXPECT_TRUE(holdsTruth(threeBearings({many, few})));
}
}  // namespace mrpt_ext::test_propose_from_association
