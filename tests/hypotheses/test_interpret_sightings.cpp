#include "mrpt_ext/hypotheses/interpret_sightings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact_scene.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const PoseRegion kRegion{{-3, -3}, {9, 9}};
const Pose2 kRobot{2.5, 2, 0.7};
const ExactSensor kEye{.named = false, .T_robot_sensor = {0.4, 0.3, -1.2}};

std::vector<LandmarkSighting> sightingsOf(const std::vector<Reading>& readings)
{
  return unidentifiedSightings(readings, kMap);
}

bool holdsTruth(const SightingInterpretations& found, const Pose2& robot = kRobot)
{
  return std::any_of(found.hypotheses.begin(), found.hypotheses.end(),
                     [&](const PoseHypothesis& h)
                     { return distance(h.pose.mean, robot) < 0.01 && turned(h.pose.mean, robot) < 0.01; });
}
}  // namespace

TEST(InterpretSightings, PosesAreTheRobotsNotTheSensors)
{
  const auto found =
      interpretSightings(sightingsOf({seenFrom(kRobot, kMap, {3, 1, 0, 2, 4}, kEye)}), kMap, kRegion, false);
  EXPECT_EQ(found.status, SolveStatus::ok);
  ASSERT_FALSE(found.hypotheses.empty());
  EXPECT_LT(distance(found.hypotheses[0].pose.mean, kRobot), 1e-4);
}

TEST(InterpretSightings, TheCovarianceIsTheRobotsToo)
{
  RandomStream random(2);
  Matrix3d sampled = Matrix3d::Zero(), said = Matrix3d::Zero();
  constexpr int kCount = 2000;
  for (int k = 0; k < kCount; ++k)
  {
    Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
    for (Detection& d : reading.detections) d.bearing = wrap(*d.bearing + d.std_bearing * random.gaussian());
    const auto found = interpretSightings(sightingsOf({reading}), kMap, kRegion, false);
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

TEST(InterpretSightings, ThreeBearingsOnlyWhenAllowed)
{
  const auto sightings = sightingsOf({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)});
  EXPECT_EQ(interpretSightings(sightings, kMap, kRegion, false).status, SolveStatus::too_few);
  const auto found = interpretSightings(sightings, kMap, kRegion, true);
  EXPECT_TRUE(holdsTruth(found));
  EXPECT_GT(found.hypotheses.size(), 1u);
  EXPECT_EQ(interpretSightings(sightingsOf({seenFrom(kRobot, kMap, {0, 1}, kEye)}), kMap, kRegion, true).status,
            SolveStatus::too_few);
  EXPECT_EQ(interpretSightings({}, kMap, kRegion, true).status, SolveStatus::too_few);
}

TEST(InterpretSightings, OneOfFiveMayShowNothing)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  for (std::size_t wrong = 0; wrong < 5; ++wrong)
  {
    Reading spoilt = reading;
    spoilt.detections[wrong].bearing = wrap(*spoilt.detections[wrong].bearing + 0.5);
    EXPECT_TRUE(holdsTruth(interpretSightings(sightingsOf({spoilt}), kMap, kRegion, false))) << wrong;
  }
}

TEST(InterpretSightings, CategoriesNarrowTheChoice)
{
  ExactSensor coloured = kEye;
  coloured.category = true;
  const Reading reading = seenFrom(kRobot, kMap, {0, 1, 2}, coloured);
  const auto plain = interpretSightings(sightingsOf({seenFrom(kRobot, kMap, {0, 1, 2}, kEye)}), kMap, kRegion, true);
  const auto narrowed = interpretSightings(sightingsOf({reading}), kMap, kRegion, true);
  EXPECT_TRUE(holdsTruth(narrowed));
  EXPECT_LT(narrowed.hypotheses.size(), plain.hypotheses.size());
}

TEST(InterpretSightings, ACategoryThatNoLandmarkHasIsClutter)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  reading.detections.insert(reading.detections.begin(),
                            {.category = "unicorn", .bearing = 0.4, .std_bearing = kEye.std_bearing});
  EXPECT_TRUE(holdsTruth(interpretSightings(sightingsOf({reading}), kMap, kRegion, false)));
  Reading only_three = seenFrom(kRobot, kMap, {0, 1, 2}, kEye);
  only_three.detections.push_back({.category = "unicorn", .bearing = 0.4, .std_bearing = kEye.std_bearing});
  EXPECT_EQ(interpretSightings(sightingsOf({only_three}), kMap, kRegion, false).status, SolveStatus::too_few);
}

TEST(InterpretSightings, TakesThePlaceWithMostBearingsAndOfEqualsTheNewest)
{
  ExactSensor other = kEye;
  other.T_robot_sensor = {-0.5, 0, 2};
  // Bearings of the smaller reading contradict the pose: they must not be used.
  const Reading few = seenFrom({8, 8, 3}, kMap, {0, 1, 2}, other), many = seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye);
  EXPECT_TRUE(holdsTruth(interpretSightings(sightingsOf({few, many}), kMap, kRegion, false)));
  EXPECT_TRUE(holdsTruth(interpretSightings(sightingsOf({many, few}), kMap, kRegion, false)));
  const Reading older = seenFrom({8, 8, 3}, kMap, {0, 1, 2, 3, 4}, other);
  EXPECT_TRUE(holdsTruth(interpretSightings(sightingsOf({older, many}), kMap, kRegion, false)));
}

TEST(InterpretSightings, ManyBearingsAreThinned)
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
  const auto sightings = unidentifiedSightings({{seenFrom(kRobot, map, places, kEye)}}, map);
  EXPECT_TRUE(holdsTruth(interpretSightings(sightings, map, kRegion, false)));
}

TEST(InterpretSightings, OutsideTheRegionIsNoSolution)
{
  const auto found = interpretSightings(sightingsOf({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kEye)}), kMap,
                                        {{-3, -3}, {-2, -2}}, false);
  EXPECT_EQ(found.status, SolveStatus::none);
  EXPECT_TRUE(found.hypotheses.empty());
}
}  // namespace mrpt_ext
