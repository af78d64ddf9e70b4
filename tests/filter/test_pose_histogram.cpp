#include "mrpt_ext/filter/modes/pose_histogram.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_pose_histogram
{
namespace
{
constexpr double kSize = 0.25, kTurn = degToRad(20.0);

ParticleSet spread(std::size_t count)
{
  RandomStream random(count);
  ParticleSet particles(Vector2d(3.1, -2.2));
  for (std::size_t i = 0; i < count; ++i)
    particles.add({random.uniform(2, 5), random.uniform(-4, -1), random.uniform(-kPi, kPi)}, random.uniform());
  normalizeWeights(particles);
  return particles;
}

/// Number of every particle's cell.
std::vector<int> cellsOf(PoseHistogram cells)
{
  std::vector<int> numbers(cells.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  return std::move(cells).labelParticles(numbers, 1);
}
}  // namespace

TEST(PoseHistogram, EveryParticleLiesInItsCell)
{
  const ParticleSet particles = spread(5000);
  const PoseHistogram cells(particles, kSize, kTurn, 1);
  const std::vector<int> cell_of = cellsOf(cells);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Pose2 middle = cells.middle(static_cast<std::size_t>(cell_of[i])), pose = particles.pose(i);
    EXPECT_LE(std::abs(pose.x - middle.x), kSize / 2 + 1e-5);
    EXPECT_LE(std::abs(pose.y - middle.y), kSize / 2 + 1e-5);
    EXPECT_LE(std::abs(wrap(pose.phi - middle.phi)), kTurn / 2 + 1e-5);
  }
}

TEST(PoseHistogram, MomentsOfAllCellsAreThoseOfTheParticles)
{
  const ParticleSet particles = spread(5000);
  const PoseHistogram cells(particles, kSize, kTurn, 1);
  double weight = 0;
  Vector2d mean = Vector2d::Zero();
  double xx = 0;
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    const CellMoments m = cells.moments(k);
    const Vector2d middle = cells.middle(k).position();
    weight += m.weight;
    mean += m.weight * middle + m.first.head<2>();
    xx += m.second(0, 0) + 2 * middle.x() * m.first.x() + m.weight * middle.x() * middle.x();
  }
  Vector2d expected = Vector2d::Zero();
  double expected_xx = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double w = std::exp(double{particles.log_weight[i]});
    expected += w * particles.pose(i).position();
    expected_xx += w * particles.pose(i).x * particles.pose(i).x;
  }
  EXPECT_NEAR(weight, 1, 1e-5);
  EXPECT_NEAR((mean - expected).norm(), 0, 1e-4);
  EXPECT_NEAR(xx, expected_xx, 1e-3);
}

TEST(PoseHistogram, HeadingCellsWrapAtPi)
{
  ParticleSet particles;
  particles.add({0.1, 0.1, degToRad(175)}, 0);
  particles.add({0.1, 0.1, degToRad(-175)}, 0);
  particles.add({0.1, 0.1, 0}, 0);
  normalizeWeights(particles);
  const PoseHistogram cells(particles, kSize, kTurn, 1);
  ASSERT_EQ(cells.size(), 3u);
  const std::vector<int> cell_of = cellsOf(cells);
  std::set<std::size_t> near;
  cells.forNeighbours(static_cast<std::size_t>(cell_of[0]), [&](std::size_t cell) { near.insert(cell); });
  EXPECT_EQ(near, std::set<std::size_t>{static_cast<std::size_t>(cell_of[1])});
}

TEST(PoseHistogram, TheResultDoesNotDependOnTheNumberOfThreads)
{
  const ParticleSet particles = spread(50000);
  const PoseHistogram one(particles, kSize, kTurn, 1), four(particles, kSize, kTurn, 4);
  ASSERT_EQ(one.size(), four.size());
  EXPECT_EQ(cellsOf(one), cellsOf(four));
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one.weight(k), four.weight(k));
}
}  // namespace mrpt_ext::test_pose_histogram
