#include "mrpt_ext/filter/integrity/symmetric_rivals.h"

#include <gtest/gtest.h>

#include "simulated_run.h"

namespace mrpt_ext::test_symmetric_rivals
{
namespace
{
constexpr double kMost = 14;
const PoseRegion kEverywhere{{0, 0}, {10, 10}};
const Pose2 kThere{7, 4, 0.5};
const Pose2 kImage{3, 6, 0.5 - kPi};

/// Half a turn about (5, 5) leaves the first eight as they are; nothing corresponds to the ninth.
LandmarkTable mapWith(bool odd_landmark)
{
  std::vector<Landmark> landmarks;
  for (const Vector3d& place : {Vector3d{1, 2, 0}, {3, 8, 0}, {0.5, 6.2, 0}, {6, 1.5, 0}})
    for (const Vector3d& position : {place, Vector3d{Vector3d{10, 10, 0} - place}})
      landmarks.push_back({.position = position});
  if (odd_landmark) landmarks.push_back({.position = {8.5, 5.5, 0}});
  return LandmarkTable(landmarks);
}

double oddsAfterStartIn(const PoseRegion& region)
{
  SymmetricRivals rivals(mapWith(false), kMost);
  rivals.start();
  rivals.leaveOutOf(region, {kThere, Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()}, {});
  return rivals.logOdds();
}

/// What a robot at kThere sees, from the particles of `pose`.
double oddsAt(const Pose2& pose, const LandmarkTable& map, std::size_t detections, int frames)
{
  const SimulatedRobot robot{.measures_range = true, .identified = false, .detections = detections, .clutter = 0.05};
  SymmetricRivals rivals(map, kMost);
  RandomStream random(2);
  for (int k = 0; k < frames; ++k)
    rivals.update(simulatedFrame(robot, map, kThere, {}, random).readings, map, particlesAt(pose, random));
  return rivals.logOdds();
}

GaussianPose precise(const Pose2& pose) { return {pose, Vector3d(0.01, 0.01, 0.001).asDiagonal()}; }
}  // namespace

TEST(SymmetricRivals, NoneInAMapWithoutSymmetries)
{
  RandomStream random(1);
  const SymmetricRivals rivals(randomMap(40, 20, random), kMost);
  EXPECT_TRUE(rivals.empty());
  EXPECT_EQ(rivals.logOdds(), kMost);
  EXPECT_FALSE(rivals.strongest());
}

TEST(SymmetricRivals, AStartThatLeavesOutTheImageTellsThemApart)
{
  EXPECT_EQ(oddsAfterStartIn(kEverywhere), 0);
  EXPECT_EQ(oddsAfterStartIn({{5, 0}, {10, 10}}), kMost);
  EXPECT_EQ(oddsAfterStartIn({{0, 0}, {10, 10}, 0, kPi / 2}), kMost) << "by the heading";
  SymmetricRivals known(mapWith(false), kMost);
  EXPECT_EQ(known.logOdds(), 0);
  const Pose2 image = compose(known.strongest().value(), kThere);
  EXPECT_LT(distance(image, kImage), 1e-9);
  EXPECT_NEAR(wrap(image.phi - kImage.phi), 0, 1e-9);
  known.accept();
  EXPECT_EQ(known.logOdds(), kMost);
}

TEST(SymmetricRivals, APreciseStartIsComparedWithTheBox)
{
  // The box reaches across the middle by 0.5 m.
  const PoseRegion region{{4.5, 0}, {10, 10}};
  const auto odds = [&](const Pose2& now, double walk)
  {
    SymmetricRivals rivals(mapWith(false), kMost);
    rivals.leaveOutOf(region, {now, Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()}, {{2, 0, 0}, 0, square(walk)});
    return rivals.logOdds();
  };
  EXPECT_EQ(odds({8, 5, 0}, 0), kMost) << "at the start it was at 6, the image at 4";
  EXPECT_EQ(odds({8, 5, 0}, 1), 0) << "... if it went where odometry says";
  EXPECT_EQ(odds({7.3, 5, 0}, 0), 0) << "at 5.3, the image at 4.7";
  EXPECT_EQ(odds({5, 5, 0}, 0), 0) << "at 3: something else is wrong";
}

TEST(SymmetricRivals, OnlyWhatHasNoCounterpartTellsThemApart)
{
  for (const Pose2& pose : {kThere, kImage}) EXPECT_NEAR(oddsAt(pose, mapWith(false), 8, 20), 0, 1e-6);
  const LandmarkTable map = mapWith(true);
  EXPECT_LE(oddsAt(kThere, map, 9, 1), 4.5) << "one frame is not enough";
  EXPECT_EQ(oddsAt(kThere, map, 9, 10), kMost);
  EXPECT_EQ(oddsAt(kImage, map, 9, 10), -kMost);
}

TEST(SymmetricRivals, ALandmarkThatIsMissedTellsThemApart)
{
  const LandmarkTable map = mapWith(true);
  for (const Pose2& robot : {kThere, kImage})
  {
    Frame frame;
    RandomStream random(3);
    frame = simulatedFrame({.measures_range = true, .identified = false, .detections = 8}, mapWith(false), robot, {},
                           random);
    Reading& reading = frame.readings.front();
    reading.model.has_field_of_view = true;
    reading.model.field_of_view = degToRad(100);
    reading.model.detection_probability = 0.9;
    // The ninth landmark is in view from kThere, and hidden.
    SymmetricRivals rivals(map, kMost);
    rivals.look(reading, map, particlesAt(robot, random));
    if (robot.x == kThere.x)
      EXPECT_LT(rivals.logOdds(), -1);
    else
      EXPECT_GT(rivals.logOdds(), 1);
  }
}

TEST(SymmetricRivals, AJumpKeepsWhatWasKnownOnlyNearThePose)
{
  const auto after = [](const Pose2& now)
  {
    SymmetricRivals rivals(mapWith(false), kMost);
    rivals.accept();
    rivals.rememberVerified();
    rivals.changeMode(precise(kThere), now);
    return rivals.logOdds();
  };
  EXPECT_GT(after({7.4, 4.2, 0.7}), 9) << "a slip";
  EXPECT_LT(after(kImage), -9);
  EXPECT_NEAR(after({1, 1, 3}), 0, 0.1) << "carried away";
}

TEST(SymmetricRivals, AModeThatNothingLedToStartsWithTheOddsOfTheStart)
{
  const LandmarkTable map = mapWith(true);
  SymmetricRivals rivals(map, kMost);
  rivals.start();
  rivals.leaveOutOf({{5, 0}, {10, 10}}, precise(kThere), {});
  EXPECT_EQ(rivals.logOdds(), kMost);
  RandomStream random(2);
  const SimulatedRobot robot{.measures_range = true, .identified = false, .detections = 9, .clutter = 0.05};
  for (int k = 0; k < 20; ++k)
    rivals.update(simulatedFrame(robot, map, kThere, {}, random).readings, map, particlesAt(kImage, random));
  EXPECT_LT(rivals.logOdds(), -9);
  rivals.changeMode(std::nullopt, kThere);
  EXPECT_EQ(rivals.logOdds(), 0) << "nor does what the box told of the other mode count";
}

TEST(SymmetricRivals, AGivenStartTellsThemApartAsFarAsItIsPrecise)
{
  const auto odds = [](double std, const Pose2& now)
  {
    SymmetricRivals rivals(mapWith(false), kMost);
    rivals.startAt({kThere, Vector3d(square(std), square(std), 1).asDiagonal()}, now);
    return rivals.logOdds();
  };
  EXPECT_EQ(odds(0.5, {7.2, 4.1, 0.6}), kMost);
  EXPECT_LT(odds(5, {7.2, 4.1, 0.6}), 9);
  EXPECT_GT(odds(5, {7.2, 4.1, 0.6}), 0);
  EXPECT_EQ(odds(0.5, kImage), -kMost);
}

// What fits a landmark that was never seen when it was in view is clutter.
TEST(SymmetricRivals, ClutterAtTheUnseenLandmarkProvesLittle)
{
  const LandmarkTable map = mapWith(true), seen = mapWith(false);
  const SimulatedRobot robot{.std_bearing = degToRad(5),
                             .std_range = 0.5,
                             .measures_range = true,
                             .identified = false,
                             .detections = 8,
                             .clutter = 0.05};
  SimulatedRobot exact = robot;
  exact.std_bearing = exact.std_range = 1e-6;
  const auto odds_after = [&](int looks)
  {
    SymmetricRivals rivals(map, kMost);
    RandomStream random(5);
    for (int k = 0; k < looks; ++k)
    {
      const std::vector<Reading> readings = simulatedFrame(robot, seen, kThere, {}, random).readings;
      rivals.update(readings, map, particlesAt(kThere, random));
      rivals.look(readings.front(), map, particlesAt(kThere, random));
    }
    const double before = rivals.logOdds();
    std::vector<Reading> clutter = simulatedFrame(exact, LandmarkTable({map[8]}), kThere, {}, random).readings;
    clutter.front().detections.front().std_bearing = robot.std_bearing;
    clutter.front().detections.front().std_range = robot.std_range;
    rivals.update(clutter, map, particlesAt(kThere, random));
    return rivals.logOdds() - before;
  };
  EXPECT_EQ(odds_after(0), 4.5) << "as much as one frame counts";
  EXPECT_LT(odds_after(100), 3);
}

TEST(SymmetricRivals, DoubtForgetsWhatCountsAgainstThePose)
{
  const LandmarkTable map = mapWith(true);
  SymmetricRivals rivals(map, kMost);
  RandomStream random(2);
  const SimulatedRobot robot{.measures_range = true, .identified = false, .detections = 9, .clutter = 0.05};
  for (int k = 0; k < 10; ++k)
    rivals.update(simulatedFrame(robot, map, kThere, {}, random).readings, map, particlesAt(kImage, random));
  rivals.doubt();
  EXPECT_EQ(rivals.logOdds(), 0);
}

TEST(SymmetricRivals, ACompassTellsWhatIsTurned)
{
  RandomStream random(1);
  const auto odds = [&](double heading, double std)
  {
    SymmetricRivals rivals(mapWith(false), kMost);
    rivals.useHeading({.heading = heading, .std_heading = std}, particlesAt(kThere, random));
    return rivals.logOdds();
  };
  EXPECT_EQ(odds(kThere.phi + 0.1, 0.2), kMost);
  EXPECT_EQ(odds(kImage.phi, 0.2), -kMost) << "the pose under test is the image";
  EXPECT_LT(odds(kThere.phi, 2), 3);
}

TEST(SymmetricRivals, AFilterIsOkOnlyIfItsStartLeavesOutTheImage)
{
  const LandmarkTable map = mapWith(false);
  const auto frames_ok = [&](const PoseRegion& region, InitialMode mode)
  {
    ParticleFilterOptions options;
    options.region = region;
    options.initial_mode = mode;
    options.initial_pose = precise({7, 4, 0});
    options.particles = 1500;
    options.initial_particles = 20000;
    options.mode_kalman_filters = false;  // so that one of two modes dies out
    options.motion = motionModelOf({});
    ParticleFilter filter(options, map, 1, 0);
    RandomStream random(4);
    const SimulatedRobot robot{.measures_range = true, .identified = false, .detections = 8, .clutter = 0.02};
    Pose2 truth{7, 4, 0};
    int ok = 0;
    for (int k = 0; k < 150; ++k)
    {
      truth = compose(truth, roundTripStep(k));
      const FilterStep step =
          filter.process(simulatedFrame(robot, map, truth, roundTripStep(k), random), {noProposals});
      if (step.verdict != Verdict::ok) continue;
      ++ok;
      EXPECT_LT(distance(step.modes.modes.front().pose.mean, truth), 0.3) << k;
    }
    return ok;
  };
  EXPECT_EQ(frames_ok(kEverywhere, InitialMode::uniform), 0);
  EXPECT_GT(frames_ok({{5, 0}, {10, 10}}, InitialMode::uniform), 90);
  EXPECT_EQ(frames_ok(kEverywhere, InitialMode::gaussian), 150);
}

// The density of a robot that was carried anywhere is large on a small field.
TEST(SymmetricRivals, AKnownStartOnASmallFieldStaysKnown)
{
  const LandmarkTable map(
      {{.position = {0, 0, 0}}, {.position = {2, 1.5, 0}}, {.position = {0.3, 1.2, 0}}, {.position = {1.7, 0.3, 0}}});
  const SimulatedRobot robot{.odometry_std = {0.001, 0.001, 0.002},
                             .std_range = 0.01,
                             .measures_range = true,
                             .identified = false,
                             .detections = 4,
                             .clutter = 0.02};
  ParticleFilterOptions options;
  options.region = {{-1, -1}, {3, 2.5}};
  options.initial_mode = InitialMode::gaussian;
  options.initial_pose = {{1.3, 0.5, 0}, Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()};
  options.particles = 1500;
  options.motion = motionModelOf(robot);
  ParticleFilter filter(options, map, 1, 0);
  RandomStream random(4);
  Pose2 truth = options.initial_pose.mean;
  for (int k = 0; k < 100; ++k)
  {
    const Pose2 step{0.01, 0, 0.02};
    truth = compose(truth, step);
    const FilterStep result = filter.process(simulatedFrame(robot, map, truth, step, random), {noProposals});
    EXPECT_EQ(result.verdict, Verdict::ok) << k << ": " << result.reason;
  }
}
}  // namespace mrpt_ext::test_symmetric_rivals
