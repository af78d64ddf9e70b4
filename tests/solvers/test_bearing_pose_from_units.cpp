#include "mrpt_ext/solvers/bearing_pose_from_units.h"

#include <gtest/gtest.h>

#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/plane.h"
#include "random_scene.h"

namespace mrpt_ext::test_bearing_pose_from_units
{
namespace
{
std::vector<UnitBearing> unitsOf(const std::vector<KnownBearing>& bearings)
{
  std::vector<UnitBearing> units;
  for (const KnownBearing& b : bearings) units.push_back({b.landmark, direction(b.bearing)});
  return units;
}

double error(const BearingPoseFromUnits& a, const Pose2& b)
{
  return (a.position - b.position()).norm() + std::abs(wrap(angleOf(a.heading) - b.phi));
}
}  // namespace

TEST(BearingPoseFromUnits, IsTheLinearSolverWithAndWithoutNoise)
{
  RandomStream random(1);
  int solved = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const bool exact = trial % 2 == 0;
    const Scene scene = randomScene(random, 3 + trial % 10);
    const auto bearings = measureBearings(scene, random, exact ? 0 : 0.02, 0.02);
    const BearingPoseLinear linear = solveBearingPoseLinear(bearings);
    const BearingPoseFromUnits fast = solveBearingPoseFromUnits(unitsOf(bearings));
    ASSERT_EQ(fast.status, linear.status) << trial;
    EXPECT_NEAR(fast.det_ratio, linear.det_ratio, 1e-12);
    if (fast.status != SolveStatus::ok) continue;
    ++solved;
    EXPECT_LT(error(fast, linear.pose), 1e-6 * (10 + fast.position.norm())) << trial;
    if (exact)
    {
      EXPECT_LT(error(fast, scene.robot), 1e-6) << trial;
    }
    EXPECT_NEAR(fast.heading.norm(), 1, 1e-12);
  }
  EXPECT_GT(solved, 800);
}

TEST(BearingPoseFromUnits, AHundredBearingsAreNoSpecialCase)
{
  RandomStream random(5);
  for (const int count : {64, 65, 66, 100})
  {
    const Scene scene = randomScene(random, count);
    const auto bearings = measureBearings(scene, random, 0, 0.02);
    auto units = unitsOf(bearings);
    ASSERT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::ok);
    EXPECT_LT(error(solveBearingPoseFromUnits(units), scene.robot), 1e-6);
    units.back().unit = -units.back().unit;
    EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::behind);
  }
}

TEST(BearingPoseFromUnits, TwoBearingsAreTooFew)
{
  const std::vector<UnitBearing> two{{{1, 0}, {1, 0}}, {{0, 1}, {0, 1}}};
  EXPECT_EQ(solveBearingPoseFromUnits(two).status, SolveStatus::too_few);
}

TEST(BearingPoseFromUnits, ATurnedBearingIsBehind)
{
  RandomStream random(2);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Scene scene = randomScene(random, 3 + trial % 8);
    auto units = unitsOf(measureBearings(scene, random, 0, 0.01));
    Vector2d& turned = units[static_cast<std::size_t>(trial) % units.size()].unit;
    turned = -turned;
    EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::behind) << trial;
  }
}

TEST(BearingPoseFromUnits, OneCircleATwinOfTheReferenceOrNoNumberIsDegenerate)
{
  Scene scene;
  for (const double angle : {0.1, 1.0, 2.5, 4.0}) scene.landmarks.emplace_back(5 * direction(angle));
  scene.robot = {0, -5, 0.3};
  RandomStream random(3);
  auto units = unitsOf(measureBearings(scene, random, 0, 0.01));
  EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::degenerate);
  EXPECT_LT(solveBearingPoseFromUnits(units).det_ratio, 1e-12);

  scene.robot = {1, 2, 0.3};
  units = unitsOf(measureBearings(scene, random, 0, 0.01));
  EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::ok);
  units[2] = units[0];
  EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::degenerate);
  units[2].landmark.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solveBearingPoseFromUnits(units).status, SolveStatus::degenerate);
}

TEST(BearingPoseFromUnits, TurnsAndShiftsWithTheLandmarks)
{
  RandomStream random(4);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Scene scene = randomScene(random, 4 + trial % 6);
    auto units = unitsOf(measureBearings(scene, random, 0.002, 0.002));
    const BearingPoseFromUnits before = solveBearingPoseFromUnits(units);
    if (before.status != SolveStatus::ok) continue;
    const Pose2 motion{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-kPi, kPi)};
    for (UnitBearing& u : units) u.landmark = transform(motion, u.landmark);
    const Pose2 expected = compose(motion, {before.position.x(), before.position.y(), angleOf(before.heading)});
    const BearingPoseFromUnits after = solveBearingPoseFromUnits(units);
    ASSERT_EQ(after.status, SolveStatus::ok) << trial;
    EXPECT_LT(error(after, expected), 1e-6 * (10 + before.position.norm())) << trial;
  }
}
}  // namespace mrpt_ext::test_bearing_pose_from_units
