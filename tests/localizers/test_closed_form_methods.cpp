#include "mrpt_ext/localizers/closed_form_methods.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_closed_form_methods
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const PoseRegion kRegion{{-3, -3}, {9, 9}};
const Pose2 kRobot{2.5, 2, 0.7};
const ExactSensor kBearings{.T_robot_sensor = {0.4, 0.1, -0.9}};
const ExactSensor kRanges{.bearing = false, .range = true};
const ExactSensor kPoints{.range = true, .T_robot_sensor = {0.4, 0.1, -0.9}};

Frame frameOf(std::vector<Reading> readings) { return {.time = 1, .readings = std::move(readings)}; }

void expectPose(const ClosedFormResult& answer, const Pose2& expected, double tolerance = 1e-6)
{
  ASSERT_EQ(answer.status, SolveStatus::ok);
  ASSERT_EQ(answer.candidates.size(), 1u);
  EXPECT_LT(distance(answer.candidates[0].pose.mean, expected), tolerance);
  EXPECT_LT(turned(answer.candidates[0].pose.mean, expected), tolerance);
  EXPECT_GT(answer.candidates[0].pose.covariance.diagonal().minCoeff(), 0);
}
}  // namespace

TEST(BearingMethods, ASensorOffTheCentreIsExact)
{
  const Frame frame = frameOf({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kBearings)});
  expectPose(bearingLeastSquares(frame, kMap), kRobot);
  expectPose(bearingMaximumLikelihood(frame, kMap), kRobot);
}

TEST(BearingMethods, MaximumLikelihoodUsesAllSensorPoses)
{
  const ExactSensor other{.T_robot_sensor = {-0.3, 0.2, 2}};
  const Frame frame = frameOf({seenFrom(kRobot, kMap, {0, 1, 2}, kBearings), seenFrom(kRobot, kMap, {2, 3, 4}, other)});
  expectPose(bearingMaximumLikelihood(frame, kMap), kRobot);
  // The linear form takes them all from the centre: near, not exact.
  const ClosedFormResult linear = bearingLeastSquares(frame, kMap);
  ASSERT_EQ(linear.status, SolveStatus::ok);
  EXPECT_LT(distance(linear.candidates[0].pose.mean, kRobot), 0.6);
}

TEST(BearingMethods, RepeatedMeasurementsCountAsTheirMean)
{
  Reading once = seenFrom(kRobot, kMap, {0, 1, 2}, kBearings), twice = once, four_times = once;
  four_times.detections.clear();
  for (Detection d : once.detections)
    for (const double off : {-0.03, 0.03, -0.01, 0.01})
    {
      four_times.detections.push_back(d);
      four_times.detections.back().bearing = wrap(*d.bearing + off);
    }
  const ClosedFormResult single = bearingLeastSquares(frameOf({once}), kMap);
  const ClosedFormResult averaged = bearingLeastSquares(frameOf({four_times}), kMap);
  expectPose(averaged, kRobot);
  expectPose(bearingMaximumLikelihood(frameOf({four_times}), kMap), kRobot);
  EXPECT_TRUE(averaged.candidates[0].pose.covariance.isApprox(single.candidates[0].pose.covariance / 4, 1e-6));
}

TEST(BearingMethods, RepeatedMeasurementsAreAveragedOnTheCircle)
{
  const Pose2 robot{2, 2, 0};
  const LandmarkTable map({{.id = 1, .position = {-3, 2, 0}},
                           {.id = 2, .position = {2, 7, 0}},
                           {.id = 3, .position = {6, 1, 0}},
                           {.id = 4, .position = {4, 6, 0}}});
  Reading reading = seenFrom(robot, map, {0, 0, 1, 2, 3}, {});
  reading.detections[0].bearing = kPi - 0.02;
  reading.detections[1].bearing = -kPi + 0.02;
  expectPose(bearingMaximumLikelihood(frameOf({reading}), map), robot);
}

TEST(BearingMethods, NeedThreeDifferentLandmarksOfTheMap)
{
  Reading strangers = seenFrom(kRobot, kMap, {0, 1, 1, 1}, kBearings);
  strangers.detections.push_back({.id = 77, .bearing = 1.0, .std_bearing = 0.01});
  strangers.detections.push_back({.bearing = 2.0, .std_bearing = 0.01});
  for (const auto& answer :
       {bearingLeastSquares(frameOf({strangers}), kMap), bearingMaximumLikelihood(frameOf({strangers}), kMap)})
  {
    EXPECT_EQ(answer.status, SolveStatus::too_few);
    EXPECT_TRUE(answer.candidates.empty());
  }
  EXPECT_EQ(bearingLeastSquares({}, kMap).status, SolveStatus::too_few);
}

TEST(RangeLeastSquares, TwoRangesGiveTwoPositionsUnlessTheRegionRemovesOne)
{
  const LandmarkTable map({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {6, 0, 0}}});
  // 3-4-5 triangles: (3, 4) and (3, -4) are 5 m from both.
  const Frame frame = frameOf({seenFrom({3, 4, 1}, map, {0, 1}, kRanges)});
  const ClosedFormResult both = rangeLeastSquares(frame, map, {{-9, -9}, {9, 9}});
  ASSERT_EQ(both.candidates.size(), 2u);
  double y_sum = 0;
  for (const PoseHypothesis& h : both.candidates)
  {
    EXPECT_NEAR(h.pose.mean.x, 3, 1e-6);
    EXPECT_NEAR(std::abs(h.pose.mean.y), 4, 1e-6);
    EXPECT_FALSE(h.heading_known);
    y_sum += h.pose.mean.y;
  }
  EXPECT_NEAR(y_sum, 0, 1e-6);
  EXPECT_TRUE(estimateFrom(both, 0).ambiguous);

  const Estimate one = estimateFrom(rangeLeastSquares(frame, map, {{-9, 0}, {9, 9}}), 0);
  ASSERT_TRUE(one.point);
  EXPECT_NEAR(one.point->pose.mean.y, 4, 1e-6);
  EXPECT_FALSE(one.point->heading_known);
}

TEST(RangeLeastSquares, NothingInTheRegionIsNoSolution)
{
  const Frame frame = frameOf({seenFrom(kRobot, kMap, {0, 1, 2}, kRanges)});
  const ClosedFormResult answer = rangeLeastSquares(frame, kMap, {{50, 50}, {60, 60}});
  EXPECT_TRUE(answer.candidates.empty());
  EXPECT_EQ(answer.status, SolveStatus::none);
}

TEST(RangeLeastSquares, ThreeRangesDetermineThePosition)
{
  const ClosedFormResult answer =
      rangeLeastSquares(frameOf({seenFrom(kRobot, kMap, {0, 2, 3}, kRanges)}), kMap, kRegion);
  ASSERT_EQ(answer.candidates.size(), 1u);
  EXPECT_LT(distance(answer.candidates[0].pose.mean, kRobot), 1e-6);
}

TEST(RangeLeastSquares, AnOffsetInflatesTheCovarianceByAtLeastItself)
{
  const ExactSensor mast{.bearing = false, .range = true, .T_robot_sensor = {0.3, 0.4, 0}};
  const ClosedFormResult answer = rangeLeastSquares(frameOf({seenFrom(kRobot, kMap, {0, 2, 3}, mast)}), kMap, kRegion);
  ASSERT_EQ(answer.candidates.size(), 1u);
  EXPECT_NEAR(distance(answer.candidates[0].pose.mean, kRobot), 0.5, 1e-6);
  EXPECT_GE(answer.candidates[0].pose.covariance(0, 0), 0.25);
  EXPECT_GE(answer.candidates[0].pose.covariance(1, 1), 0.25);
}

TEST(RangeLeastSquares, OneRangeIsTooFew)
{
  const Frame frame = frameOf({seenFrom(kRobot, kMap, {1, 1}, kRanges)});
  EXPECT_EQ(rangeLeastSquares(frame, kMap, kRegion).status, SolveStatus::too_few);
}

TEST(TwoLandmarkPose, ASensorOffTheCentreIsExact)
{
  expectPose(twoLandmarkPose(frameOf({seenFrom(kRobot, kMap, {0, 2}, kPoints)}), kMap), kRobot);
  expectPose(twoLandmarkPose(frameOf({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kPoints)}), kMap), kRobot);
  const ExactSensor other{.range = true, .T_robot_sensor = {-0.3, 0.2, 2}};
  expectPose(twoLandmarkPose(frameOf({seenFrom(kRobot, kMap, {0}, kPoints), seenFrom(kRobot, kMap, {1}, other)}), kMap),
             kRobot);
}

TEST(TwoLandmarkPose, AveragesRepeatedPoints)
{
  Reading reading = seenFrom(kRobot, kMap, {0, 0, 2}, kPoints);
  *reading.detections[0].range += 0.05;
  *reading.detections[1].range -= 0.05;
  expectPose(twoLandmarkPose(frameOf({reading}), kMap), kRobot);
}

TEST(TwoLandmarkPose, LandmarksFartherFromEachOtherThanOnTheMapAreDoubtful)
{
  for (const std::vector<std::size_t>& seen : {std::vector<std::size_t>{0, 2}, {0, 1, 2, 3, 4}})
  {
    Reading reading = seenFrom(kRobot, kMap, seen, kPoints);
    for (Detection& d : reading.detections) *d.range += d.std_range;
    EXPECT_TRUE(twoLandmarkPose(frameOf({reading}), kMap).unique) << seen.size();
    for (Detection& d : reading.detections) *d.range += 9 * d.std_range;
    EXPECT_FALSE(twoLandmarkPose(frameOf({reading}), kMap).unique) << seen.size();
  }
}

TEST(TwoLandmarkPose, OnePointIsTooFewAndBearingsAloneAreNoPoints)
{
  EXPECT_EQ(twoLandmarkPose(frameOf({seenFrom(kRobot, kMap, {0, 0}, kPoints)}), kMap).status, SolveStatus::too_few);
  EXPECT_EQ(twoLandmarkPose(frameOf({seenFrom(kRobot, kMap, {0, 1, 2}, kBearings)}), kMap).status,
            SolveStatus::too_few);
}

TEST(InterpretationTree, FindsThePoseFromAnonymousBearings)
{
  ExactSensor anonymous = kBearings;
  anonymous.identified = false;
  const Estimate estimate =
      estimateFrom(interpretationTree(frameOf({seenFrom(kRobot, kMap, {4, 1, 0, 3, 2}, anonymous)}), kMap,
                                      GlobalPoseSearch(kMap), kRegion),
                   0);
  ASSERT_FALSE(estimate.candidates.empty());
  EXPECT_LT(distance(estimate.candidates[0].pose.mean, kRobot), 1e-4);
  EXPECT_LT(turned(estimate.candidates[0].pose.mean, kRobot), 1e-4);
  for (const PoseHypothesis& h : estimate.candidates) EXPECT_TRUE(kRegion.contains(h.pose.mean));
}

TEST(InterpretationTree, ThreeBearingsAndIdentifiedOnesAreTooFew)
{
  ExactSensor anonymous = kBearings;
  anonymous.identified = false;
  EXPECT_EQ(
      interpretationTree(frameOf({seenFrom(kRobot, kMap, {0, 1, 2}, anonymous)}), kMap, GlobalPoseSearch(kMap), kRegion)
          .status,
      SolveStatus::too_few);
  EXPECT_EQ(interpretationTree(frameOf({seenFrom(kRobot, kMap, {0, 1, 2, 3, 4}, kBearings)}), kMap,
                               GlobalPoseSearch(kMap), kRegion)
                .status,
            SolveStatus::too_few);
}

TEST(InterpretationTree, ASymmetricMapGivesSeveralPosesOfEqualScore)
{
  const LandmarkTable square(
      {{.position = {0, 0, 0}}, {.position = {4, 0, 0}}, {.position = {4, 4, 0}}, {.position = {0, 4, 0}}});
  ExactSensor anonymous;
  anonymous.identified = false;
  const Pose2 robot{1, 1.5, 0.3};
  const ClosedFormResult answer = interpretationTree(frameOf({seenFrom(robot, square, {0, 1, 2, 3}, anonymous)}),
                                                     square, GlobalPoseSearch(square), {{0, 0}, {4, 4}});
  // The square has a symmetry of a quarter turn.
  ASSERT_GE(answer.candidates.size(), 4u);
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    const Vector2d there = Vector2d(2, 2) + rotation(quarter * kPi / 2) * (robot.position() - Vector2d(2, 2));
    const Pose2 twin{there.x(), there.y(), wrap(robot.phi + quarter * kPi / 2)};
    EXPECT_TRUE(std::any_of(answer.candidates.begin(), answer.candidates.end(),
                            [&](const PoseHypothesis& h)
                            { return distance(h.pose.mean, twin) < 1e-3 && turned(h.pose.mean, twin) < 1e-3; }))
        << quarter;
  }
  EXPECT_TRUE(estimateFrom(answer, 0).ambiguous);
}
}  // namespace mrpt_ext::test_closed_form_methods
