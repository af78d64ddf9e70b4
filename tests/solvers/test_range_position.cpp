#include "mrpt_ext/solvers/range_position.h"

#include <gtest/gtest.h>

#include "mrpt_ext/solvers/range_position_robust.h"
#include "random_scene.h"

namespace mrpt_ext::test_range_position
{
namespace
{
std::vector<KnownRange> measure(const std::vector<Vector2d>& landmarks, const Vector2d& position, RandomStream& random,
                                double noise, double std)
{
  std::vector<KnownRange> ranges;
  for (const Vector2d& l : landmarks)
    ranges.push_back({l, std::max(0.0, (l - position).norm() + noise * random.gaussian()), std});
  return ranges;
}
}  // namespace

TEST(RangePosition, TwoRangesGiveTheTwoPlaces)
{
  const std::vector<KnownRange> ranges = {{{0, 0}, 5, 0.1}, {{6, 0}, 5, 0.1}};
  const RangePositions r = solveRangePosition(ranges);
  ASSERT_EQ(r.candidates.size(), 2u);
  for (const RangePosition& c : r.candidates)
  {
    EXPECT_NEAR(c.position.mean.x(), 3, 1e-9);
    EXPECT_NEAR(std::abs(c.position.mean.y()), 4, 1e-9);
  }
}

TEST(RangePosition, AThirdRangeOffTheLineDecides)
{
  const std::vector<KnownRange> ranges = {{{0, 0}, 5, 0.1}, {{6, 0}, 5, 0.1}, {{3, 10}, 6, 0.1}};
  const RangePositions r = solveRangePosition(ranges);
  ASSERT_EQ(r.candidates.size(), 1u);
  EXPECT_LT((r.candidates[0].position.mean - Vector2d(3, 4)).norm(), 1e-9);
}

TEST(RangePosition, LandmarksOnOneLineLeaveTheMirrorImage)
{
  const std::vector<KnownRange> ranges = {{{0, 0}, 5, 0.1}, {{6, 0}, 5, 0.1}, {{3, 0}, 4, 0.1}};
  const RangePositions r = solveRangePosition(ranges);
  ASSERT_EQ(r.candidates.size(), 2u);
  EXPECT_NEAR(r.candidates[0].position.mean.y(), -r.candidates[1].position.mean.y(), 1e-9);
}

TEST(RangePosition, ReachesTheCramerRaoLimitAndSaysSo)
{
  RandomStream random(81);
  const std::vector<Vector2d> landmarks = {{0, 0}, {10, 0}, {9, 8}, {1, 9}};
  const Vector2d truth(3, 4);
  Matrix2d scatter = Matrix2d::Zero(), reported = Matrix2d::Zero();
  const int trials = 3000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const RangePositions r = solveRangePosition(measure(landmarks, truth, random, 0.1, 0.1));
    ASSERT_EQ(r.candidates.size(), 1u);
    const Vector2d e = r.candidates[0].position.mean - truth;
    scatter += e * e.transpose() / trials;
    reported += r.candidates[0].position.covariance / trials;
  }
  EXPECT_NEAR(scatter(0, 0) / reported(0, 0), 1, 0.1);
  EXPECT_NEAR(scatter(1, 1) / reported(1, 1), 1, 0.1);
}

TEST(RangePosition, CirclesThatMissEachOtherStillGiveAPlace)
{
  const std::vector<KnownRange> ranges = {{{0, 0}, 1, 0.1}, {{4, 0}, 2, 0.1}};
  const RangePositions r = solveRangePosition(ranges);
  ASSERT_EQ(r.status, SolveStatus::ok);
  EXPECT_NEAR(r.candidates[0].position.mean.x(), 1.5, 1e-6);
  EXPECT_GT(r.candidates[0].position.covariance(1, 1), 10 * r.candidates[0].position.covariance(0, 0));
}

TEST(RangePosition, NeverNaN)
{
  RandomStream random(82);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const Scene scene = randomScene(random, 2 + trial % 5);
    std::vector<KnownRange> ranges;
    for (const Vector2d& l : scene.landmarks) ranges.push_back({l, random.uniform(0, 12), 0.1});
    const RangePositions r = solveRangePosition(ranges);
    ASSERT_EQ(r.status, SolveStatus::ok);
    for (const RangePosition& c : r.candidates)
      EXPECT_TRUE(c.position.mean.allFinite() && c.position.covariance.allFinite() && std::isfinite(c.chi2));
  }
  EXPECT_EQ(solveRangePosition(std::vector<KnownRange>{{{0, 0}, 1, 1}}).status, SolveStatus::too_few);
  EXPECT_EQ(solveRangePosition(std::vector<KnownRange>(3, {{0, 0}, 1, 1})).status, SolveStatus::degenerate);
  EXPECT_EQ(solveRangePosition(std::vector<KnownRange>(3, {{0, 0}, -1, 1})).status, SolveStatus::bad_input);
}

TEST(RangePositionRobust, OneWildRangeIsFoundAndLeftOut)
{
  RandomStream random(83);
  int right = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::vector<Vector2d> landmarks = {{0, 0}, {10, 0}, {9, 8}, {1, 9}, {5, -3}};
    const Vector2d truth(random.uniform(2, 8), random.uniform(1, 7));
    std::vector<KnownRange> ranges = measure(landmarks, truth, random, 0.05, 0.05);
    const std::size_t wild = static_cast<std::size_t>(trial % 5);
    ranges[wild].range += 3;
    const RobustRangePositions r = solveRangePositionRobust(ranges);
    ASSERT_EQ(r.status, SolveStatus::ok);
    const bool found = (r.candidates[0].fit.position.mean - truth).norm() < 0.3;
    right += found && !r.candidates[0].inliers[wild] ? 1 : 0;
  }
  EXPECT_GE(right, 198);  // by chance a wild range fits a wrong place with three others
}

TEST(RangePositionRobust, WithoutWildRangesItIsThePlainSolution)
{
  RandomStream random(84);
  const std::vector<Vector2d> landmarks = {{0, 0}, {10, 0}, {9, 8}, {1, 9}};
  for (int trial = 0; trial < 50; ++trial)
  {
    const auto ranges = measure(landmarks, {4, 5}, random, 0.02, 0.05);
    const RobustRangePositions robust = solveRangePositionRobust(ranges);
    ASSERT_EQ(robust.candidates.size(), 1u);
    EXPECT_EQ(robust.candidates[0].inlier_count, 4);
    EXPECT_LT((robust.candidates[0].fit.position.mean - solveRangePosition(ranges).candidates[0].position.mean).norm(),
              1e-8);
  }
}
}  // namespace mrpt_ext::test_range_position
