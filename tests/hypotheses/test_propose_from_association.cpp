#include "mrpt_ext/hypotheses/propose_from_association.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "exact_scene.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const GlobalPoseSearch kSearch(kMap);
const PoseRegion kRegion{{-3, -3}, {9, 9}};
const Pose2 kRobot{2.5, 2, 0.7};
const ExactSensor kEye{.named = false, .T_robot_sensor = {0.4, 0.3, -1.2}};

ReadingInterpretation interpret(const std::vector<Reading>& readings)
{
  return interpretReadings(readings, kMap, kSearch, kRegion);
}

HypothesisSet interpretThree(const std::vector<Reading>& readings)
{
  return interpretThreeBearings(readings, kMap, kSearch, kRegion);
}

bool holdsTruth(const HypothesisSet& found, const Pose2& robot = kRobot)
{
  return std::any_of(found.begin(), found.end(),
                     [&](const PoseHypothesis& h)
                     { return distance(h.pose.mean, robot) < 0.01 && turned(h.pose.mean, robot) < 0.01; });
}
}  // namespace

TEST(InterpretReadings, PosesAreTheRobotsNotTheSensors)
{
  const auto found = interpret({seenFrom(kRobot, kMap, {3, 1, 0, 2, 4}, kEye)});
  EXPECT_EQ(found.status, SolveStatus::ok);
  ASSERT_FALSE(found.hypotheses.empty());
  EXPECT_LT(distance(found.hypotheses[0].pose.mean, kRobot), 1e-4);
}

TEST(InterpretReadings, TheCovarianceIsTheRobotsToo)
{
  RandomStream random(2);
  Matrix3d sampled = Matrix3d::Zero(), said = Matrix3d::Zero();
  constexpr int kCount = 2000;
  for (int k = 0; k < kCount; ++k)
  {
    Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
    for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
    const auto found = interpret({reading});
    const auto truth = std::min_element(found.hypotheses.begin(), found.hypotheses.end(),
                                        [](const auto& a, const auto& b)
                                        { return distance(a.pose.mean, kRobot) < distance(b.pose.mean, kRobot); });
    ASSERT_NE(truth, found.hypotheses.end());
    const Pose2& m = truth->pose.mean;
    const Vector3d d(m.x - kRobot.x, m.y - kRobot.y, wrap(m.phi - kRobot.phi));
    sampled += d * d.transpose() / kCount;
    said += truth->pose.covariance / kCount;
  }
  EXPECT_LT((sampled - said).norm(), 0.15 * said.norm()) << sampled << "\n\n" << said;
}

TEST(InterpretReadings, NothingToInterpretIsTooFew)
{
  EXPECT_EQ(interpret({}).status, SolveStatus::too_few);
  ExactSensor named = kEye;
  named.named = true;
  EXPECT_EQ(interpret({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, named)}).status, SolveStatus::too_few);
}

TEST(InterpretReadings, OneOfFiveMayShowNothing)
{
  const Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  for (std::size_t wrong = 0; wrong < 5; ++wrong)
  {
    Reading spoilt = reading;
    spoilt.detections[wrong].bearing = wrap(*spoilt.detections[wrong].bearing + 0.5);
    EXPECT_TRUE(holdsTruth(interpret({spoilt}).hypotheses)) << wrong;
  }
}

TEST(InterpretReadings, ACategoryThatNoLandmarkHasIsClutter)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  reading.detections.insert(reading.detections.begin(),
                            {.category = "unicorn", .bearing = 0.4, .std_bearing = kEye.std_bearing});
  EXPECT_TRUE(holdsTruth(interpret({reading}).hypotheses));
}

TEST(InterpretReadings, ReadingsOfAllPlacesAreExplainedTogether)
{
  ExactSensor other = kEye;
  other.T_robot_sensor = {-0.5, 0, 2};
  const Reading front = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kEye), back = seenFrom(kRobot, kMap, {4, 1}, other);
  const auto alone = interpret({front}), together = interpret({front, back});
  ASSERT_FALSE(together.hypotheses.empty());
  EXPECT_LT(distance(together.hypotheses[0].pose.mean, kRobot), 1e-4);
  ASSERT_FALSE(alone.hypotheses.empty());
  EXPECT_LT(together.hypotheses[0].pose.covariance.determinant(), alone.hypotheses[0].pose.covariance.determinant());
}

TEST(InterpretReadings, PointsAreSoughtAsConstellations)
{
  ExactSensor ranger = kEye;
  ranger.range = true;
  const auto two = interpret({seenFrom(kRobot, kMap, {0, 2}, ranger)});
  EXPECT_TRUE(holdsTruth(two.hypotheses));
  const auto four = interpret({seenFrom(kRobot, kMap, {0, 2, 3, 4}, ranger)});
  ASSERT_FALSE(four.hypotheses.empty());
  EXPECT_LT(distance(four.hypotheses[0].pose.mean, kRobot), 1e-4);
}

TEST(InterpretReadings, ManyBearings)
{
  std::vector<Landmark> landmarks;
  RandomStream random(9);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < 25; ++i)
  {
    landmarks.push_back({.position = {random.uniform(-3, 9), random.uniform(-3, 9), 0}});
    places.push_back(i);
  }
  const LandmarkTable map(landmarks);
  const std::vector readings{seenFrom(kRobot, map, places, kEye)};
  const auto found = interpretReadings(readings, map, GlobalPoseSearch(map), kRegion);
  ASSERT_FALSE(found.hypotheses.empty());
  EXPECT_LT(distance(found.hypotheses[0].pose.mean, kRobot), 0.01);
  EXPECT_TRUE(found.unique);
}

TEST(InterpretReadings, OutsideTheRegionIsNoSolution)
{
  const std::vector readings{seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye)};
  const auto found = interpretReadings(readings, kMap, kSearch, {{-3, -3}, {-2, -2}});
  EXPECT_EQ(found.status, SolveStatus::none);
  EXPECT_TRUE(found.hypotheses.empty());
}

TEST(InterpretThreeBearings, ManyPosesThatNothingVerifies)
{
  const HypothesisSet found = interpretThree({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)});
  EXPECT_TRUE(holdsTruth(found));
  EXPECT_GT(found.size(), 1u);
  EXPECT_TRUE(interpretThree({seenFrom(kRobot, kMap, {0, 1}, kEye)}).empty());
  EXPECT_TRUE(interpretThree({}).empty());
  EXPECT_TRUE(interpretThree({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye)}).empty());
}

TEST(InterpretThreeBearings, OneOfFourMayShowNothing)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3}, kEye);
  reading.detections[1].bearing = wrap(*reading.detections[1].bearing + 0.5);
  EXPECT_TRUE(holdsTruth(interpretThree({reading})));
}

TEST(InterpretThreeBearings, CategoriesNarrowTheChoice)
{
  ExactSensor coloured = kEye;
  coloured.category = true;
  const auto plain = interpretThree({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)});
  const auto narrowed = interpretThree({seenFrom(kRobot, kMap, {0, 1, 2}, coloured)});
  EXPECT_TRUE(holdsTruth(narrowed));
  EXPECT_LT(narrowed.size(), plain.size());
}

TEST(InterpretThreeBearings, TakesThePlaceWithMostBearings)
{
  ExactSensor other = kEye;
  other.T_robot_sensor = {-0.5, 0, 2};
  const Reading few = seenFrom({8, 8, 3}, kMap, {0, 1}, other), many = seenFrom(kRobot, kMap, {0, 1, 2}, kEye);
  EXPECT_TRUE(holdsTruth(interpretThree({few, many})));
  EXPECT_TRUE(holdsTruth(interpretThree({many, few})));
}
}  // namespace mrpt_ext
