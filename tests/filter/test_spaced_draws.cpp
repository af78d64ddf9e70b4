#include "mrpt_ext/filter/particles/spaced_draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mrpt_ext::test_spaced_draws
{
TEST(SpacedDraws, EachParticleIsDrawnInProportionToItsWeight)
{
  ParticleSet particles(Vector2d(0, 0));
  for (int i = 0; i < 1000; ++i) particles.add({0, 0, 0}, std::log(i < 500 ? 1.0 : 3.0));
  normalizeWeights(particles);
  for (const unsigned threads : {1U, 4U})
  {
    const std::vector<std::size_t> draws = spacedDraws(particles, 40, threads);
    ASSERT_EQ(draws.size(), 40U);
    EXPECT_TRUE(std::is_sorted(draws.begin(), draws.end()));
    EXPECT_EQ(std::count_if(draws.begin(), draws.end(), [](std::size_t i) { return i < 500; }), 10);
  }
}

TEST(SpacedDraws, OneParticleIsDrawnAgainAndAgain)
{
  ParticleSet particles(Vector2d(0, 0));
  particles.add({0, 0, 0}, 0);
  EXPECT_EQ(spacedDraws(particles, 3), std::vector<std::size_t>(3, 0));
  EXPECT_TRUE(spacedDraws(particles.emptyLikeThis(), 3).empty());
}
}  // namespace mrpt_ext::test_spaced_draws
