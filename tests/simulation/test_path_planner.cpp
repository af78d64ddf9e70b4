#include "mrpt_ext/simulation/path_planner.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_path_planner
{
namespace
{
RobotPath plan(const PathPlan& path, double duration)
{
  RandomStream random(1);
  return planPath(path, duration, random);
}

PathPlan triangle()
{
  PathPlan path;
  path.kind = PathKind::waypoints;
  path.waypoints = {{0, 0}, {4, 0}, {4, 3}};
  path.speed = 0.5;
  path.turn_rate = 1;
  return path;
}
}  // namespace

TEST(PathPlanner, TurnsInPlaceAtTheWaypoints)
{
  const RobotPath path = plan(triangle(), 100);
  EXPECT_NEAR(path.poseAt(0).x, 0, 1e-12);
  EXPECT_NEAR(path.poseAt(8).x, 4, 1e-12);
  const double turn = kPi / 2;  // at 1 rad/s
  EXPECT_NEAR(path.poseAt(8 + turn).phi, kPi / 2, 1e-9);
  EXPECT_NEAR(path.poseAt(8 + turn + 6).y, 3, 1e-9);
}

TEST(PathPlanner, ClosedPathRepeats)
{
  for (const double turn_radius : {0.0, 0.3})
  {
    PathPlan closed = triangle();
    closed.turn_radius = turn_radius;
    const RobotPath path = plan(closed, 200);
    EXPECT_GE(path.duration(), 200);
    const double cut = turn_radius * (std::tan(kPi / 4) + std::tan((kPi - std::atan2(4, 3)) / 2) +
                                      std::tan((kPi - std::atan2(3, 4)) / 2));  // at each end of a corner
    const double length = 12 - 2 * cut + kTwoPi * turn_radius;
    const double round = length / 0.5 + (turn_radius > 0 ? 0 : kTwoPi / 1.0);
    EXPECT_NEAR(path.lengthAt(round), length, 1e-9);
    for (const double t : {0.0, 5.0, 15.0})
    {
      EXPECT_NEAR(path.poseAt(round + t).x, path.poseAt(t).x, 1e-9);
      EXPECT_NEAR(path.poseAt(round + t).y, path.poseAt(t).y, 1e-9);
      EXPECT_NEAR(wrap(path.poseAt(round + t).phi - path.poseAt(t).phi), 0, 1e-9);
    }
  }
}

TEST(PathPlanner, OpenPathEndsAtItsLastWaypoint)
{
  PathPlan open = triangle();
  open.closed = false;
  open.turn_radius = 0.5;
  const RobotPath path = plan(open, 1000);
  EXPECT_NEAR(path.poseAt(1000).x, 4, 1e-9);
  EXPECT_NEAR(path.poseAt(1000).y, 3, 1e-9);
  EXPECT_NEAR(path.poseAt(1000).phi, kPi / 2, 1e-9);
}

TEST(PathPlanner, RoundedSquareStaysInsideItsCornersInBothDirections)
{
  for (const bool clockwise : {false, true})
  {
    PathPlan square;
    square.kind = PathKind::square;
    square.centre = {1, 2};
    square.side = 4;
    square.turn_radius = 1;
    square.speed = 1;
    square.clockwise = clockwise;
    const RobotPath path = plan(square, 50);
    const double round = 8 + kTwoPi;
    for (double t = 0; t < 40; t += 0.1)
    {
      const Vector2d from_centre = path.poseAt(t).position() - square.centre;
      EXPECT_LE(from_centre.cwiseAbs().maxCoeff(), 2 + 1e-9);
      EXPECT_GE(from_centre.norm(), 2 - 1e-9);
    }
    EXPECT_NEAR((path.poseAt(round).position() - path.poseAt(0).position()).norm(), 0, 1e-9);
    EXPECT_NEAR(path.turnedAt(round), kTwoPi, 1e-9);
    EXPECT_EQ(path.poseAt(0).x, 1);
    EXPECT_EQ(wrap(path.poseAt(3.5).phi) > 0, !clockwise);
  }
}

TEST(PathPlanner, CircleKeepsItsRadius)
{
  PathPlan circle;
  circle.kind = PathKind::circle;
  circle.centre = {5, 5};
  circle.radius = 3;
  const RobotPath path = plan(circle, 100);
  for (double t = 0; t < 100; t += 1) EXPECT_NEAR((path.poseAt(t).position() - circle.centre).norm(), 3, 1e-9);
  EXPECT_NEAR(path.lengthAt(100), 30, 1e-9);
}

TEST(PathPlanner, RandomWalkStaysInsideAndMoves)
{
  PathPlan walk;
  walk.kind = PathKind::random_walk;
  walk.start = {1, 1, 0};
  walk.low = {0, 0};
  walk.high = {4, 3};
  const RobotPath path = plan(walk, 600);
  EXPECT_GT(path.lengthAt(600), 60);
  for (double t = 0; t < 600; t += 0.1)
  {
    EXPECT_GE(path.poseAt(t).x, -0.05);
    EXPECT_LE(path.poseAt(t).x, 4.05);
    EXPECT_GE(path.poseAt(t).y, -0.05);
    EXPECT_LE(path.poseAt(t).y, 3.05);
  }
}

TEST(PathPlanner, RejectsImpossiblePaths)
{
  PathPlan tight = triangle();
  tight.turn_radius = 2.5;
  EXPECT_THROW((void)plan(tight, 10), InputError);
  PathPlan back_and_forth = triangle();
  back_and_forth.waypoints.pop_back();
  EXPECT_NO_THROW((void)plan(back_and_forth, 10));
  back_and_forth.turn_radius = 0.1;
  EXPECT_THROW((void)plan(back_and_forth, 10), InputError);
  PathPlan twice = triangle();
  twice.waypoints[1] = twice.waypoints[0];
  EXPECT_THROW((void)plan(twice, 10), InputError);
  PathPlan outside;
  outside.kind = PathKind::random_walk;
  outside.start = {1, 1, 0};
  EXPECT_THROW((void)plan(outside, 10), InputError);
}
}  // namespace mrpt_ext::test_path_planner
