#include "mrpt_ext/localizers/running_fix_localizer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hypotheses/exact_scene.h"

namespace mrpt_ext::test_running_fix_localizer
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {4, 3, 0}}, {.id = 2, .position = {-2, 5, 0}}});
const Pose2 kFirst{0, 0, 0.2};
const Pose2 kStep{2, 0.3, 0.5};
const Pose2 kSecond = compose(kFirst, kStep);
const ExactSensor kRange{.bearing = false, .range = true};

RunningFixOptions optionsFor(HeadingSource source)
{
  RunningFixOptions options;
  options.heading_source = source;
  options.region = {{-20, -20}, {20, 20}};
  return options;
}

OdometryMotion motionOf(const Pose2& increment)
{
  return {increment, increment.position().norm(), std::abs(increment.phi), 1};
}

/// A frame with the ranges of these landmarks, taken at `robot` by `sensor`.
Frame frameAt(double time, const Pose2& robot, const Pose2& increment, const std::vector<std::size_t>& landmarks,
              const ExactSensor& sensor = kRange)
{
  return {.time = time, .motion = motionOf(increment), .readings = {seenFrom(robot, kMap, landmarks, sensor, time)}};
}

Frame withCompass(Frame frame, double heading)
{
  frame.compass = CompassRecord{frame.time, "compass", heading, degToRad(1)};
  return frame;
}

/// The fix of landmark 1 between kFirst and kSecond, as an instrument would log it.
RunningFixReading loggedFix()
{
  RunningFixReading fix{.time = 1, .sensor = "sonar", .id = 1};
  fix.first_range = predictRange(kFirst, {4, 3});
  fix.second_range = predictRange(kSecond, {4, 3});
  fix.first_std = fix.second_std = 0.02;
  fix.displacement = kStep;
  fix.displacement_covariance = Vector3d(1e-4, 1e-4, 1e-5).asDiagonal();
  return fix;
}

bool contains(const HypothesisSet& candidates, const Pose2& pose, double tolerance = 1e-6)
{
  return std::any_of(candidates.begin(), candidates.end(),
                     [&](const PoseHypothesis& h)
                     { return distance(h.pose.mean, pose) < tolerance && turned(h.pose.mean, pose) < tolerance; });
}
}  // namespace

TEST(RunningFixLocalizer, ALoggedFixAndACompassGiveTwoPoses)
{
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  EXPECT_EQ(localizer.name(), "running_fix");
  EXPECT_FALSE(localizer.continuous());
  Frame frame = withCompass({.time = 1}, kSecond.phi);
  frame.fixes = {loggedFix()};
  const Estimate estimate = localizer.process(frame);
  EXPECT_EQ(estimate.status, SolveStatus::ok);
  EXPECT_EQ(estimate.candidates.size(), 2u);
  EXPECT_TRUE(contains(estimate.candidates, kSecond));
  EXPECT_TRUE(estimate.ambiguous);
  EXPECT_FALSE(estimate.point);
}

TEST(RunningFixLocalizer, TheRegionOrABearingResolvesTheAmbiguity)
{
  Frame frame = withCompass({.time = 1}, kSecond.phi);
  frame.fixes = {loggedFix()};
  RunningFixOptions options = optionsFor(HeadingSource::compass);
  const Estimate both = RunningFixLocalizer(options, kMap).process(frame);
  const Pose2 twin = both.candidates[contains({both.candidates[0]}, kSecond) ? 1 : 0].pose.mean;
  const Vector2d half(0.5 * distance(twin, kSecond), 0.5 * distance(twin, kSecond));
  options.region = {kSecond.position() - half, kSecond.position() + half};
  ASSERT_FALSE(options.region.contains(twin));
  const Estimate one = RunningFixLocalizer(options, kMap).process(frame);
  ASSERT_TRUE(one.point);
  EXPECT_LT(distance(one.point->pose.mean, kSecond), 1e-6);

  frame.fixes[0].second_bearing = predictBearing(kSecond, {4, 3});
  frame.fixes[0].second_bearing_std = degToRad(2);
  const Estimate seen = RunningFixLocalizer(optionsFor(HeadingSource::compass), kMap).process(frame);
  ASSERT_TRUE(seen.point);
  EXPECT_EQ(seen.candidates.size(), 2u);
  EXPECT_LT(distance(seen.point->pose.mean, kSecond), 1e-6);
}

TEST(RunningFixLocalizer, TwoRangesWithOdometryInBetweenAreAFix)
{
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  EXPECT_EQ(localizer.process(withCompass(frameAt(0, kFirst, {}, {0}), kFirst.phi)).status, SolveStatus::too_few);
  const Estimate estimate = localizer.process(withCompass(frameAt(1, kSecond, kStep, {0}), kSecond.phi));
  EXPECT_EQ(estimate.candidates.size(), 2u);
  EXPECT_TRUE(contains(estimate.candidates, kSecond));
  EXPECT_TRUE(estimate.ambiguous);
}

TEST(RunningFixLocalizer, MotionOfFramesInBetweenAddsUp)
{
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  Pose2 robot = kFirst;
  (void)localizer.process(withCompass(frameAt(0, robot, {}, {0}), robot.phi));
  for (int k = 1; k < 5; ++k)
  {
    robot = compose(robot, {0.5, 0, 0.2});
    Frame between = withCompass({.time = double(k), .motion = motionOf({0.5, 0, 0.2})}, robot.phi);
    EXPECT_FALSE(localizer.process(between).point);
  }
  robot = compose(robot, {0.5, 0, 0.2});
  EXPECT_TRUE(
      contains(localizer.process(withCompass(frameAt(5, robot, {0.5, 0, 0.2}, {0}), robot.phi)).candidates, robot));
}

TEST(RunningFixLocalizer, TheCompassHeadingIsPropagatedByOdometry)
{
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  (void)localizer.process(withCompass(frameAt(0, kFirst, {}, {0}), kFirst.phi));
  EXPECT_TRUE(contains(localizer.process(frameAt(1, kSecond, kStep, {0})).candidates, kSecond));
}

TEST(RunningFixLocalizer, ASecondLandmarkResolvesTheAmbiguity)
{
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  (void)localizer.process(withCompass(frameAt(0, kFirst, {}, {0}), kFirst.phi));
  const Estimate estimate = localizer.process(withCompass(frameAt(1, kSecond, kStep, {0, 1}), kSecond.phi));
  ASSERT_TRUE(estimate.point);
  EXPECT_LT(distance(estimate.point->pose.mean, kSecond), 1e-6);
}

TEST(RunningFixLocalizer, TwoSensorsMakeAFixTogether)
{
  const ExactSensor left{.bearing = false, .range = true, .T_robot_sensor = {0.2, 0.5, 0.3}};
  const ExactSensor right{.bearing = false, .range = true, .T_robot_sensor = {-0.1, -0.5, 2}};
  RunningFixLocalizer localizer(optionsFor(HeadingSource::compass), kMap);
  (void)localizer.process(withCompass(frameAt(0, kFirst, {}, {0}, left), kFirst.phi));
  EXPECT_TRUE(contains(localizer.process(withCompass(frameAt(1, kSecond, kStep, {0}, right), kSecond.phi)).candidates,
                       kSecond));
}

TEST(RunningFixLocalizer, TooShortADistanceOrTooOldARangeIsNoFix)
{
  RunningFixLocalizer near(optionsFor(HeadingSource::compass), kMap);
  (void)near.process(withCompass(frameAt(0, kFirst, {}, {0}), kFirst.phi));
  const Pose2 little{0.19, 0, 0};  // below ten standard deviations of a range
  const Estimate none = near.process(withCompass(frameAt(1, compose(kFirst, little), little, {0}), kFirst.phi));
  EXPECT_EQ(none.status, SolveStatus::too_few);
  EXPECT_TRUE(none.candidates.empty());

  RunningFixLocalizer late(optionsFor(HeadingSource::compass), kMap);
  (void)late.process(withCompass(frameAt(0, kFirst, {}, {0}), kFirst.phi));
  Frame after_a_minute = withCompass(frameAt(61, kSecond, kStep, {0}), kSecond.phi);
  after_a_minute.motion.duration = 61;
  EXPECT_EQ(late.process(after_a_minute).status, SolveStatus::too_few);
}

TEST(RunningFixLocalizer, WithoutAHeadingThereIsARingAndNoEstimate)
{
  for (const HeadingSource source : {HeadingSource::none, HeadingSource::bearing, HeadingSource::filter})
  {
    RunningFixLocalizer localizer(optionsFor(source), kMap);
    (void)localizer.process(frameAt(0, kFirst, {}, {0}));
    Frame frame = frameAt(1, kSecond, kStep, {0});
    if (source == HeadingSource::none) frame = withCompass(frame, kSecond.phi);  // it is not to be used
    const Estimate estimate = localizer.process(frame);
    EXPECT_EQ(estimate.status, SolveStatus::degenerate);
    EXPECT_FALSE(estimate.point);
    EXPECT_TRUE(estimate.candidates.empty());
  }
}

TEST(RunningFixLocalizer, TheHeadingOfTheFilterIsReadForEveryFrame)
{
  std::optional<HeadingPrior> reported;
  RunningFixLocalizer localizer(optionsFor(HeadingSource::filter), kMap, [&] { return reported; });
  (void)localizer.process(frameAt(0, kFirst, {}, {0}));
  EXPECT_EQ(localizer.process(frameAt(1, kSecond, kStep, {0})).status, SolveStatus::degenerate);
  reported = HeadingPrior{kSecond.phi, 0.01};
  EXPECT_TRUE(contains(localizer.process(frameAt(2, kSecond, {}, {0})).candidates, kSecond));
  reported.reset();
  EXPECT_EQ(localizer.process(frameAt(3, kSecond, {}, {0})).status, SolveStatus::degenerate);
}

TEST(RunningFixLocalizer, TwoLandmarksInOneFrameGiveTheHeadingThatOdometryPropagates)
{
  const ExactSensor eye{.range = true};
  RunningFixLocalizer localizer(optionsFor(HeadingSource::bearing), kMap);
  const Estimate start = localizer.process(frameAt(0, kFirst, {}, {0, 1}, eye));
  EXPECT_FALSE(start.point);  // no displacement yet between two ranges
  const Estimate estimate = localizer.process(frameAt(1, kSecond, kStep, {0}, eye));
  ASSERT_TRUE(estimate.point);
  EXPECT_LT(distance(estimate.point->pose.mean, kSecond), 1e-3);
  EXPECT_LT(turned(estimate.point->pose.mean, kSecond), 1e-3);
}

TEST(RunningFixLocalizer, AKnownInitialHeadingSuffices)
{
  RunningFixOptions options = optionsFor(HeadingSource::bearing);
  options.start_heading = HeadingPrior{kFirst.phi, 0.01};
  RunningFixLocalizer localizer(options, kMap);
  (void)localizer.process(frameAt(0, kFirst, {}, {0}));
  EXPECT_TRUE(contains(localizer.process(frameAt(1, kSecond, kStep, {0})).candidates, kSecond));
}

TEST(RunningFixLocalizer, FixesOfUnknownLandmarksAndInconsistentOnesAreNoSolution)
{
  Frame frame = withCompass({.time = 1}, kSecond.phi);
  frame.fixes = {loggedFix()};
  frame.fixes[0].id = 99;
  EXPECT_EQ(RunningFixLocalizer(optionsFor(HeadingSource::compass), kMap).process(frame).status, SolveStatus::none);
  frame.fixes = {loggedFix()};
  frame.fixes[0].sensor_height = 50;  // both ranges are shorter than the height above the landmark
  EXPECT_EQ(RunningFixLocalizer(optionsFor(HeadingSource::compass), kMap).process(frame).status, SolveStatus::none);
}

TEST(RunningFixLocalizer, NothingMeasuredIsTooFew)
{
  EXPECT_EQ(RunningFixLocalizer(optionsFor(HeadingSource::compass), kMap).process({}).status, SolveStatus::too_few);
}
}  // namespace mrpt_ext::test_running_fix_localizer
