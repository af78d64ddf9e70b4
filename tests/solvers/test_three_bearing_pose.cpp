#include "mrpt_ext/solvers/three_bearing_pose.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "random_scene.h"
#include "three_bearing_pose_batch.h"

namespace mrpt_ext::test_three_bearing_pose
{
namespace
{
using Sight = VisibleLandmark<double>;
using Answer = ThreeBearingPose<double>;

Sight sightOf(const Vector2d& landmark, double bearing)
{
  return {landmark.x(), landmark.y(), std::cos(bearing), std::sin(bearing)};
}

std::array<Sight, 3> sightsOf(const Scene& scene)
{
  std::array<Sight, 3> sights;
  for (std::size_t i = 0; i < 3; ++i)
    sights[i] = sightOf(scene.landmarks[i], predictBearing(scene.robot, scene.landmarks[i]));
  return sights;
}

Answer solve(const std::array<Sight, 3>& s) { return solveThreeBearingPose(s[0], s[1], s[2]); }

double error(const Answer& a, const Pose2& truth)
{
  return std::hypot(a.x - truth.x, a.y - truth.y) + std::abs(wrap(std::atan2(a.s, a.c) - truth.phi));
}

template <class Real>
struct Batch
{
  std::array<std::vector<Real>, 3> lx, ly, lc, ls;
  std::vector<Real> x, y, c, s;
  std::vector<Real> valid;

  explicit Batch(const std::vector<std::array<Sight, 3>>& problems)
      : x(problems.size()), y(problems.size()), c(problems.size()), s(problems.size()), valid(problems.size())
  {
    for (const auto& problem : problems)
      for (std::size_t i = 0; i < 3; ++i)
      {
        lx[i].push_back(static_cast<Real>(problem[i].x));
        ly[i].push_back(static_cast<Real>(problem[i].y));
        lc[i].push_back(static_cast<Real>(problem[i].c));
        ls[i].push_back(static_cast<Real>(problem[i].s));
      }
  }

  ThreeBearingArrays<Real> problems() const
  {
    ThreeBearingArrays<Real> p;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p.x[i] = lx[i].data();
      p.y[i] = ly[i].data();
      p.c[i] = lc[i].data();
      p.s[i] = ls[i].data();
    }
    p.count = x.size();
    return p;
  }

  PositionArrays<Real> positions() { return {x.data(), y.data(), valid.data()}; }
  HeadingArrays<Real> headings() { return {c.data(), s.data()}; }

  ThreeBearingPose<Real> scalar(std::size_t m) const
  {
    const auto sight = [&](std::size_t i) { return VisibleLandmark<Real>{lx[i][m], ly[i][m], lc[i][m], ls[i][m]}; };
    return solveThreeBearingPose(sight(0), sight(1), sight(2));
  }
};

/// Scenes as they come, some with a bearing turned round, an equal bearing or a landmark twice.
std::vector<std::array<Sight, 3>> mixedProblems(std::size_t count)
{
  RandomStream random(5);
  std::vector<std::array<Sight, 3>> problems;
  for (std::size_t m = 0; m < count; ++m)
  {
    problems.push_back(sightsOf(randomScene(random, 3)));
    auto& sights = problems.back();
    if (m % 5 == 1) sights[m % 3].c = -sights[m % 3].c, sights[m % 3].s = -sights[m % 3].s;
    if (m % 50 == 2) sights[0] = sights[2];
    if (m % 50 == 3) sights[1].x = std::numeric_limits<double>::quiet_NaN();
  }
  return problems;
}

/// Both agree but for rounding, which weighs `tolerance` times how far the answer lies away.
template <class Real>
void expectBatchLikeScalar(double tolerance, std::size_t may_differ)
{
  Batch<Real> batch(mixedProblems(1003));
  positionsFromThreeBearings(batch.problems(), batch.positions());
  const std::vector<Real> x = batch.x, y = batch.y;
  const std::vector<Real> valid = batch.valid;
  posesFromThreeBearings(batch.problems(), batch.positions(), batch.headings());
  std::size_t differ = 0, poses = 0;
  for (std::size_t m = 0; m < x.size(); ++m)
  {
    const ThreeBearingPose<Real> expected = batch.scalar(m);
    const double size = 10 + std::hypot(expected.x, expected.y);
    differ += valid[m] != (expected.outcome == ThreeBearingOutcome::pose) || valid[m] != batch.valid[m] ||
              !(std::hypot(x[m] - expected.x, y[m] - expected.y) <= tolerance * size) ||
              !(std::hypot(batch.x[m] - expected.x, batch.y[m] - expected.y) <= tolerance * size) ||
              !(std::hypot(batch.c[m] - expected.c, batch.s[m] - expected.s) <= tolerance * size);
    poses += valid[m] > 0;
    ASSERT_TRUE(std::isfinite(x[m]) && std::isfinite(y[m]) && std::isfinite(batch.c[m]) && std::isfinite(batch.s[m]));
  }
  EXPECT_LE(differ, may_differ);
  EXPECT_GT(poses, 700U);
  EXPECT_LT(poses, 900U);
}
}  // namespace

TEST(ThreeBearingPose, FindsTheRobotOfRandomScenes)
{
  RandomStream random(1);
  std::vector<double> errors;
  for (int trial = 0; trial < 3000; ++trial)
  {
    const Scene scene = randomScene(random, 3);
    const Answer answer = solve(sightsOf(scene));
    ASSERT_EQ(answer.outcome, ThreeBearingOutcome::pose) << trial;
    EXPECT_NEAR(std::hypot(answer.c, answer.s), 1, 1e-14);
    errors.push_back(error(answer, scene.robot));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[1500], 1e-13);
  EXPECT_LT(errors.back(), 1e-7);
}

TEST(ThreeBearingPose, OppositeAndEqualBearingsAreNoSpecialCase)
{
  const double right = 0, left = kPi, up = kPi / 2;
  const Sight east = sightOf({3, 0}, right), west = sightOf({-2, 0}, left), north = sightOf({0, 4}, up);
  for (const auto& sights : {std::array{east, west, north}, {east, north, west}, {north, east, west}})
  {
    const Answer answer = solve(sights);
    ASSERT_EQ(answer.outcome, ThreeBearingOutcome::pose);
    EXPECT_LT(error(answer, {0, 0, 0}), 1e-14);
  }
  const Sight farther = sightOf({5, 0}, right);
  for (const auto& sights : {std::array{east, farther, north}, {east, north, farther}, {north, east, farther}})
    EXPECT_LT(error(solve(sights), {0, 0, 0}), 1e-14);
}

TEST(ThreeBearingPose, ATurnedBearingIsBehind)
{
  RandomStream random(2);
  for (int trial = 0; trial < 1000; ++trial)
  {
    auto sights = sightsOf(randomScene(random, 3));
    Sight& turned = sights[static_cast<std::size_t>(trial % 3)];
    turned.c = -turned.c;
    turned.s = -turned.s;
    EXPECT_EQ(solve(sights).outcome, ThreeBearingOutcome::behind) << trial;
  }
}

TEST(ThreeBearingPose, OnOneCircleOrLineIsDegenerate)
{
  RandomStream random(3);
  int tried = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    Scene circle = randomScene(random, 3);
    for (Vector2d& l : circle.landmarks)
    {
      const double angle = random.uniform(-kPi, kPi);
      l = {5 + 4 * std::cos(angle), 5 + 4 * std::sin(angle)};
    }
    circle.robot = {5 + 4 * std::cos(trial), 5 + 4 * std::sin(trial), circle.robot.phi};
    // Rounding of its place turns the bearing of a landmark that is very close by more than rounding.
    if (std::any_of(circle.landmarks.begin(), circle.landmarks.end(),
                    [&](const Vector2d& l) { return (l - circle.robot.position()).norm() < 0.02; }))
      continue;
    ++tried;
    EXPECT_EQ(solve(sightsOf(circle)).outcome, ThreeBearingOutcome::degenerate) << trial;
  }
  EXPECT_GT(tried, 280);
  const Answer line = solve({sightOf({1, 1}, 0), sightOf({2, 2}, 0), sightOf({4, 4}, 0)});
  EXPECT_EQ(line.outcome, ThreeBearingOutcome::degenerate);
  EXPECT_EQ(line.x, 0);
  EXPECT_EQ(line.c, 1);
}

TEST(ThreeBearingPose, WhatIsNotANumberIsDegenerate)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, 1e200})
    for (std::size_t i = 0; i < 3; ++i)
    {
      std::array sights{sightOf({3, 0}, 0), sightOf({-2, 0}, kPi), sightOf({0, 4}, kPi / 2)};
      sights[i].x = bad;
      const Answer answer = solve(sights);
      EXPECT_EQ(answer.outcome, ThreeBearingOutcome::degenerate);
      EXPECT_TRUE(std::isfinite(answer.x) && std::isfinite(answer.c));
    }
}

TEST(ThreeBearingPose, TurnsAndShiftsWithTheLandmarks)
{
  RandomStream random(4);
  for (int trial = 0; trial < 300; ++trial)
  {
    Scene scene = randomScene(random, 3);
    auto sights = sightsOf(scene);
    const Answer before = solve(sights);
    const Pose2 motion{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-kPi, kPi)};
    for (Sight& s : sights)
    {
      const Vector2d moved = transform(motion, Vector2d(s.x, s.y));
      s.x = moved.x();
      s.y = moved.y();
    }
    const Pose2 expected = compose(motion, {before.x, before.y, std::atan2(before.s, before.c)});
    EXPECT_LT(error(solve(sights), expected), 1e-7) << trial;
  }
}

TEST(ThreeBearingPose, AgreesWithTheLeastSquaresOfThePaper)
{
  RandomStream random(6);
  for (const auto& s : mixedProblems(2000))
  {
    if (!std::isfinite(s[1].x)) continue;
    std::vector<UnitBearing> bearings;
    for (const Sight& sight : s) bearings.push_back({{sight.x, sight.y}, {sight.c, sight.s}});
    const BearingPoseFromUnits other = solveBearingPoseFromUnits(bearings);
    const Answer answer = solve(s);
    if (other.det_ratio < 1e-8) continue;  // where one of the two is degenerate, the other need not be
    EXPECT_EQ(answer.outcome == ThreeBearingOutcome::pose, other.status == SolveStatus::ok);
    EXPECT_EQ(answer.outcome == ThreeBearingOutcome::behind, other.status == SolveStatus::behind);
  }
}

TEST(ThreeBearingPose, BatchIsTheScalarManyTimes)
{
  expectBatchLikeScalar<double>(1e-9, 0);
  expectBatchLikeScalar<float>(1e-3, 10);
}
}  // namespace mrpt_ext::test_three_bearing_pose
