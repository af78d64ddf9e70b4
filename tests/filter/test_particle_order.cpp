#include "mrpt_ext/filter/particles/particle_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_particle_order
{
namespace
{
ParticleSet spread(std::size_t count)
{
  RandomStream random(1);
  ParticleSet particles({5, 5}, {{.kind = BiasKind::range_offset, .std = 0.1}});
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = random.uniform(0, 10), y = random.uniform(0, 10), phi = random.uniform(-3, 3);
    particles.add({x, y, phi}, x + 100 * y);
    particles.bias[0].back() = static_cast<float>(x - y);
  }
  return particles;
}

double meanStep(const ParticleSet& particles)
{
  double sum = 0;
  for (std::size_t i = 1; i < particles.size(); ++i)
    sum += (particles.pose(i).position() - particles.pose(i - 1).position()).norm();
  return sum / static_cast<double>(particles.size() - 1);
}
}  // namespace

TEST(ParticleOrder, NeighboursInMemoryAreNeighboursOnTheMap)
{
  ParticleSet particles = spread(4000);
  EXPECT_GT(meanStep(particles), 4);
  orderByPlace(particles);
  EXPECT_LT(meanStep(particles), 1.5);
}

TEST(ParticleOrder, EveryParticleStaysWhatItIs)
{
  const ParticleSet before = spread(500);
  ParticleSet after = before;
  orderByPlace(after);
  ASSERT_EQ(after.size(), before.size());
  std::vector<float> x = before.x, ordered = after.x;
  std::sort(x.begin(), x.end());
  std::sort(ordered.begin(), ordered.end());
  EXPECT_EQ(x, ordered);
  for (std::size_t i = 0; i < after.size(); ++i)
  {
    const Pose2 pose = after.pose(i);
    EXPECT_NEAR(double{after.log_weight[i]}, pose.x + 100 * pose.y, 1e-3);
    EXPECT_NEAR(double{after.bias[0][i]}, pose.x - pose.y, 1e-5);
  }
}

TEST(ParticleOrder, NoneAndCopiesAreFine)
{
  ParticleSet none({0, 0});
  orderByPlace(none);
  EXPECT_TRUE(none.empty());
  ParticleSet copies({0, 0});
  for (int i = 0; i < 5; ++i) copies.add({1, 2, 3}, 0);
  orderByPlace(copies);
  EXPECT_EQ(copies.size(), 5u);
}
}  // namespace mrpt_ext::test_particle_order
