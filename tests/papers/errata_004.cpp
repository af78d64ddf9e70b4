#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/solvers/heading_from_landmark.h"
#include "mrpt_ext/solvers/pose_ring.h"
#include "mrpt_ext/solvers/running_fix.h"
#include "mrpt_ext/solvers/two_circles.h"
#include "printed_formulas.h"
#include "proof.h"

namespace mrpt_ext::papers
{
namespace
{
/// The field of 150 x 130 cm, a goal corner, a robot that drove from `first` to `second`.
struct Example
{
  Vector2d landmark{0, 45};
  Pose2 first, second;

  Example(RandomStream& random, bool yellow = false)
  {
    if (yellow) landmark.x() = 150;
    second = {random.uniform(20, 130), random.uniform(10, 120), random.uniform(-kPi, kPi)};
    first = second;
  }
  [[nodiscard]] Vector2d way() const { return second.position() - first.position(); }
  [[nodiscard]] double firstRange() const { return (landmark - first.position()).norm(); }
  [[nodiscard]] double secondRange() const { return (landmark - second.position()).norm(); }
  [[nodiscard]] Vector2d inRobot() const { return rotation(-second.phi) * (landmark - second.position()); }
};

double nearest(const std::vector<Vector2d>& places, const Vector2d& truth)
{
  double best = 1e9;
  for (const Vector2d& place : places)
    if (place.allFinite()) best = std::min(best, (place - truth).norm());
  return best;
}

std::vector<Vector2d> placesOf(const RunningFix& fix)
{
  std::vector<Vector2d> places;
  for (const RunningFixCandidate& c : fix.candidates) places.push_back(c.second.mean);
  return places;
}

/// A way along the y axis, but for 1e-8 cm.
Erratum equationFour()
{
  Proof proof;
  RandomStream random(1);
  for (int k = 0; k < kExamples; ++k)
  {
    Example e(random);
    e.first = {e.second.x + 1e-8, e.second.y - 20, e.second.phi};
    const Vector2d shifted = e.landmark + e.way();
    std::vector<Vector2d> as_printed;
    for (const double sign : {-1.0, 1.0})
      as_printed.push_back(printed::intersection(shifted, e.firstRange(), e.landmark, e.secondRange(), sign));
    const TwoCircles circles = intersectCircles({shifted, e.firstRange()}, {e.landmark, e.secondRange()});
    // Close to a tangent the place itself hangs on the last digit.
    if (circles.count < 2 || (circles.points[0] - circles.points[1]).norm() < 5) continue;
    const std::vector<Vector2d> right(circles.points.begin(), circles.points.end());
    proof.add(nearest(as_printed, e.second.position()), nearest(right, e.second.position()));
  }
  return proof.erratum("004, eq 4", "x = A + B y, divided by the x component of the way",
                       "points along and across the line of centres", "position, way along y but for 1e-8 cm [cm]");
}

Erratum wayInRobotAxes()
{
  Proof proof;
  RandomStream random(2);
  for (int k = 0; k < kExamples; ++k)
  {
    Example e(random);
    const Vector2d in_robot(20, 10);
    const Vector2d way = rotation(e.second.phi) * in_robot;
    e.first = {e.second.x - way.x(), e.second.y - way.y(), e.second.phi};
    const auto error = [&](const Vector2d& displacement)
    {
      return nearest(placesOf(runningFix({e.landmark, displacement, e.firstRange(), e.secondRange(), 1, 1})),
                     e.second.position());
    };
    proof.add(error(in_robot), error(way));
  }
  return proof.erratum("004, eq 2", "the way by dead reckoning, as it is",
                       "the way in the axes of the field: it needs the heading", "position [cm]");
}

Erratum equationSeven()
{
  Proof proof;
  RandomStream random(3);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random);  // the blue goal is always to the left of the robot
    if (e.inRobot().x() < 0) continue;
    const auto right = headingFromLandmark(e.landmark, e.second.position(), e.inRobot());
    const double heading = printed::fixHeading(e.landmark, e.second.position(), e.inRobot());
    proof.add(radToDeg(std::abs(wrap(heading - e.second.phi))), radToDeg(std::abs(wrap(*right - e.second.phi))));
  }
  return proof.erratum("004, eq 7", "arctan", "atan2", "heading, blue goal [deg]");
}

Erratum equationEight()
{
  Proof proof;
  RandomStream random(4);
  for (int k = 0; k < kExamples; ++k)
  {
    const Example e(random, true);
    if (e.inRobot().x() < 0) continue;
    const double heading = printed::blueGoalHeading(e.landmark, e.second.position(), e.inRobot());
    const auto right = headingFromLandmark(e.landmark, e.second.position(), e.inRobot());
    proof.add(radToDeg(std::abs(wrap(heading - e.second.phi))), radToDeg(std::abs(wrap(*right - e.second.phi))));
  }
  return proof.erratum("004, eq 8", "a formula of its own for the blue goal", "eq 7 with atan2 holds for both goals",
                       "heading by eq 8 at the yellow goal [deg]");
}

/// Everything turned about the landmark: what one landmark and relative motion can tell stays the same.
Erratum oneLandmark()
{
  Proof proof;
  RandomStream random(5);
  for (int k = 0; k < kExamples; ++k)
  {
    Example e(random);
    e.first = {e.second.x - 20, e.second.y + 5, e.second.phi - 0.3};
    const double turn = random.uniform(0.5, 2);
    const auto turned = [&](const Pose2& pose)
    {
      const Vector2d p = e.landmark + rotation(turn) * (pose.position() - e.landmark);
      return Pose2{p.x(), p.y(), wrap(pose.phi + turn)};
    };
    const Pose2 first = turned(e.first), second = turned(e.second);
    const Pose2 before = between(e.first, e.second), after = between(first, second);
    const double same = std::abs(predictRange(first, e.landmark) - e.firstRange()) +
                        std::abs(predictRange(second, e.landmark) - e.secondRange()) +
                        std::abs(wrap(predictBearing(second, e.landmark) - predictBearing(e.second, e.landmark))) +
                        (before.position() - after.position()).norm() + std::abs(wrap(before.phi - after.phi));
    proof.add((second.position() - e.second.position()).norm(), same);
  }
  return proof.erratum("004, sec 2", "position and heading from one landmark and dead reckoning",
                       "a ring of poses; closing it needs a heading, a second landmark or the field",
                       "how far the robot may be turned away unnoticed [cm]; change of what it measures");
}
}  // namespace

std::vector<Erratum> errataOfPaper004()
{
  return {equationFour(), wayInRobotAxes(), equationSeven(), equationEight(), oneLandmark()};
}
}  // namespace mrpt_ext::papers
