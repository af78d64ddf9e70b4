#include "mrpt_ext/solvers/three_bearing_pose_noncentral.h"

#include <gtest/gtest.h>

#include <numeric>

#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/three_bearing_pose.h"
#include "random_scene.h"

namespace mrpt_ext::test_three_bearing_pose_noncentral
{
namespace
{
using Origins = std::array<Vector2d, 3>;
constexpr Pose2 kNowhere{1e6, 1e6, 0};

/// Lines of sight from a robot to the first three landmarks of a scene, taken at `origins` in its frame.
std::array<NoncentralBearing, 3> linesFor(const Scene& scene, const Origins& origins)
{
  std::array<NoncentralBearing, 3> lines;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector2d v = transform(inverse(scene.robot), scene.landmarks[i]) - origins[i];
    lines[i] = {scene.landmarks[i], origins[i], v.normalized()};
  }
  return lines;
}

Origins someOrigins(RandomStream& random, double size)
{
  Origins origins;
  for (Vector2d& o : origins) o = {random.uniform(-size, size), random.uniform(-size, size)};
  return origins;
}

double difference(const Pose2& a, const Pose2& b)
{
  return (a.position() - b.position()).norm() + std::abs(wrap(a.phi - b.phi));
}

double nearest(const NoncentralThreeBearingPose& answer, const Pose2& truth)
{
  double best = difference(kNowhere, truth);
  for (int k = 0; k < answer.count; ++k)
    best = std::min(best, difference(answer.poses[static_cast<std::size_t>(k)], truth));
  return best;
}
}  // namespace

TEST(NoncentralThreeBearingPose, FindsTheTruthAndOnlyPosesThatExplainTheLines)
{
  RandomStream random(1);
  int two = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    const Scene scene = randomScene(random, 3);
    const Origins origins = someOrigins(random, 2);
    const auto lines = linesFor(scene, origins);
    const NoncentralThreeBearingPose answer = solveNoncentralThreeBearingPose(lines);
    ASSERT_EQ(answer.status, SolveStatus::ok);
    two += answer.count == 2;
    if (answer.quality < 1e-3) continue;
    EXPECT_LT(nearest(answer, scene.robot), 1e-6) << trial;
    for (std::size_t k = 0; k < static_cast<std::size_t>(answer.count); ++k)
      for (const NoncentralBearing& l : lines)
      {
        const Vector2d v = (transform(inverse(answer.poses[k]), l.landmark) - l.origin).normalized();
        EXPECT_LT((v - l.direction).norm(), 1e-5) << trial;
      }
  }
  EXPECT_GT(two, 100) << "two poses are common enough to matter";
  EXPECT_LT(two, 2000);
}

TEST(NoncentralThreeBearingPose, TurningAndShiftingTheWorldTurnsAndShiftsThePoses)
{
  RandomStream random(2);
  const Pose2 move{3e4, -2e4, 2.1};
  for (int trial = 0; trial < 200; ++trial)
  {
    const Scene scene = randomScene(random, 3);
    auto lines = linesFor(scene, someOrigins(random, 1));
    const NoncentralThreeBearingPose before = solveNoncentralThreeBearingPose(lines);
    for (NoncentralBearing& l : lines) l.landmark = transform(move, l.landmark);
    const NoncentralThreeBearingPose after = solveNoncentralThreeBearingPose(lines);
    ASSERT_EQ(after.count, before.count);
    if (before.quality < 0.01) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(before.count); ++k)
      EXPECT_LT(nearest(after, compose(move, before.poses[k])), 1e-5);
  }
}

TEST(NoncentralThreeBearingPose, TheOrderOfTheLinesDoesNotMatter)
{
  RandomStream random(3);
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto lines = linesFor(randomScene(random, 3), someOrigins(random, 1));
    const NoncentralThreeBearingPose first = solveNoncentralThreeBearingPose(lines);
    const NoncentralThreeBearingPose turned = solveNoncentralThreeBearingPose({lines[2], lines[0], lines[1]});
    ASSERT_EQ(first.count, turned.count);
    EXPECT_NEAR(first.quality, turned.quality, 1e-12);
    if (first.quality < 0.01) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(first.count); ++k)
      EXPECT_LT(nearest(turned, first.poses[k]), 1e-7);
  }
}

TEST(NoncentralThreeBearingPose, WithOneOriginItIsTheThreeBearingPose)
{
  RandomStream random(4);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Scene scene = randomScene(random, 3);
    // Any three directions: with most of them some landmark is behind.
    std::array<NoncentralBearing, 3> lines = linesFor(scene, {Vector2d(0, 0), Vector2d(0, 0), Vector2d(0, 0)});
    std::array<VisibleLandmark<double>, 3> seen;
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (trial % 2) lines[i].direction = direction(random.uniform(-kPi, kPi));
      const NoncentralBearing& l = lines[i];
      seen[i] = {l.landmark.x(), l.landmark.y(), l.direction.x(), l.direction.y()};
    }
    const ThreeBearingPose<double> one = solveThreeBearingPose(seen[0], seen[1], seen[2]);
    const NoncentralThreeBearingPose path = solveNoncentralThreeBearingPose(lines);
    ASSERT_EQ(path.count, one.outcome == ThreeBearingOutcome::pose ? 1 : 0) << trial;
    EXPECT_EQ(path.status, path.count == 1 ? SolveStatus::ok : SolveStatus::behind);
    if (path.count == 0 || path.quality < 1e-3) continue;
    EXPECT_LT(nearest(path, {one.x, one.y, std::atan2(one.s, one.c)}), 1e-6) << trial;
  }
}

TEST(NoncentralThreeBearingPose, WhatCannotBeSolvedSaysWhy)
{
  const auto status = [](const std::array<NoncentralBearing, 3>& lines)
  { return solveNoncentralThreeBearingPose(lines).status; };
  const Vector2d east(1, 0), north(0, 1), nought(0, 0);
  EXPECT_EQ(status({{{{5, 1}, {0, 1}, east}, {{6, -1}, {0, -1}, east}, {{7, 3}, {0, 3}, east}}}),
            SolveStatus::degenerate)
      << "parallel lines of sight";
  // The robot on the circle through the landmarks, all seen from one place: every point of the circle fits.
  Scene circle{{{5, 0}, {0, 5}, {-5, 0}}, {-3, -4, 0.4}};
  EXPECT_EQ(status(linesFor(circle, {nought, nought, nought})), SolveStatus::degenerate);
  EXPECT_EQ(status(linesFor(circle, {nought, east, north})), SolveStatus::ok) << "the way breaks the circle";
  EXPECT_EQ(status({{{{1, 0}, nought, east}, {{1, 0}, {0, 9}, east}, {{1, 0}, {9, 9}, north}}}),
            SolveStatus::degenerate)
      << "one landmark: any heading";
  EXPECT_EQ(status({{{{0.1, 0}, nought, east}, {{0, 0.1}, {0, 90}, north}, {{0.1, 0.1}, {0, 50}, -east}}}),
            SolveStatus::none)
      << "origins too far apart for landmarks this close together";
  EXPECT_EQ(status({{{{1, 0}, nought, 2 * east}, {{0, 1}, nought, north}, {{1, 1}, nought, east}}}),
            SolveStatus::bad_input);
  EXPECT_EQ(status({{{{std::nan(""), 0}, nought, east}, {{0, 1}, nought, north}, {{1, 1}, nought, east}}}),
            SolveStatus::bad_input);
}

TEST(NoncentralThreeBearingPose, ScattersAsTheInformationSays)
{
  RandomStream random(5);
  const Scene scene{{{4, 1}, {1, 5}, {-3, -2}}, {0.5, 0.8, 0.6}};
  const Origins origins{Vector2d(-1, 0.1), Vector2d(-0.4, 0), Vector2d(0, 0)};
  const auto exact = linesFor(scene, origins);
  const double std = degToRad(0.3);
  std::vector<PoseMeasurement> rows;
  for (const NoncentralBearing& l : exact)
    rows.push_back(
        {PoseMeasurement::Kind::bearing, l.landmark, angleOf(l.direction), std, {l.origin.x(), l.origin.y(), 0}});
  const auto covariance = covarianceFromInformation(poseInformation(rows, scene.robot));
  ASSERT_TRUE(covariance);
  Matrix3d scatter = Matrix3d::Zero();
  const int trials = 4000;
  for (int trial = 0; trial < trials; ++trial)
  {
    auto lines = exact;
    for (NoncentralBearing& l : lines) l.direction = direction(angleOf(l.direction) + std * random.gaussian());
    const NoncentralThreeBearingPose answer = solveNoncentralThreeBearingPose(lines);
    const Pose2& pose = *std::min_element(answer.poses.begin(), answer.poses.end(),
                                          [&](const Pose2& a, const Pose2& b)
                                          { return difference(a, scene.robot) < difference(b, scene.robot); });
    const Vector3d e(pose.x - scene.robot.x, pose.y - scene.robot.y, wrap(pose.phi - scene.robot.phi));
    scatter += e * e.transpose() / trials;
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(scatter(i, i) / (*covariance)(i, i), 1, 0.12) << i;
}
}  // namespace mrpt_ext::test_three_bearing_pose_noncentral
