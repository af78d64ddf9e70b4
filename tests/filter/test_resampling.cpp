#include "mrpt_ext/filter/particles/resampling.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

#include "mrpt_ext/filter/particles/systematic_resampling.h"

namespace mrpt_ext::test_resampling
{
namespace
{
constexpr ResamplingMethod kMethods[] = {ResamplingMethod::multinomial, ResamplingMethod::residual,
                                         ResamplingMethod::stratified, ResamplingMethod::systematic};

std::vector<std::size_t> counts(const std::vector<std::size_t>& indices, std::size_t size)
{
  std::vector<std::size_t> result(size, 0);
  for (const std::size_t i : indices) ++result.at(i);
  return result;
}

/// Particle i sits at x = i with weight weights[i].
ParticleSet onALine(const std::vector<double>& weights)
{
  ParticleSet particles;
  for (std::size_t i = 0; i < weights.size(); ++i) particles.add({static_cast<double>(i), 0, 0}, std::log(weights[i]));
  normalizeWeights(particles);
  return particles;
}

std::vector<int> halves(const ParticleSet& particles)
{
  std::vector<int> mode_of;
  for (const float x : particles.x) mode_of.push_back(x < 500 ? 0 : 1);
  return mode_of;
}

double weightOfFirstHalf(const ParticleSet& particles)
{
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.x[i] < 500) sum += std::exp(double{particles.log_weight[i]});
  return sum;
}
}  // namespace

class EveryMethod : public ::testing::TestWithParam<ResamplingMethod>
{
};
INSTANTIATE_TEST_SUITE_P(Resampling, EveryMethod, ::testing::ValuesIn(kMethods));

TEST_P(EveryMethod, IsUnbiased)
{
  const std::vector<double> weights{0.05, 0.4, 0.0, 0.013, 0.237, 0.3};
  const std::size_t count = 10;
  const int repeats = 20000;
  RandomStream random(3);
  std::vector<double> mean(weights.size(), 0.0);
  for (int k = 0; k < repeats; ++k)
  {
    const auto drawn = counts(drawIndices(GetParam(), weights, count, random), weights.size());
    for (std::size_t i = 0; i < weights.size(); ++i) mean[i] += static_cast<double>(drawn[i]) / repeats;
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const double expected = static_cast<double>(count) * weights[i];
    EXPECT_NEAR(mean[i], expected, 4.5 * std::sqrt(expected * (1 - weights[i]) / repeats) + 1e-12) << "weight " << i;
  }
}

TEST_P(EveryMethod, DrawsTheRequestedNumberOfValidIndices)
{
  RandomStream random(4);
  for (const std::size_t count : {1, 2, 7, 1000})
  {
    const auto drawn = counts(drawIndices(GetParam(), {0, 2, 0, 6, 0}, count, random), 5);
    EXPECT_EQ(std::accumulate(drawn.begin(), drawn.end(), std::size_t{0}), count);
    EXPECT_EQ(drawn[0] + drawn[2] + drawn[4], 0u);
  }
}

TEST_P(EveryMethod, DrawsNothingWithoutWeights)
{
  RandomStream random(5);
  EXPECT_TRUE(drawIndices(GetParam(), {}, 5, random).empty());
  EXPECT_TRUE(drawIndices(GetParam(), {0, 0}, 5, random).empty());
  EXPECT_TRUE(drawIndices(GetParam(), {1, 1}, 0, random).empty());
}

TEST_P(EveryMethod, KeepsTheWeightsOfModesAndSumsToOne)
{
  std::vector<double> w(1000);
  for (std::size_t i = 0; i < w.size(); ++i) w[i] = 1.0 + static_cast<double>(i % 7);
  ParticleSet particles = onALine(w);
  const double before = weightOfFirstHalf(particles);
  RandomStream random(6);
  particles = resampleByMode(particles, halves(particles), GetParam(), 400, random);
  EXPECT_EQ(particles.size(), 400u);
  const std::vector<double> after = weights(particles);
  EXPECT_NEAR(std::accumulate(after.begin(), after.end(), 0.0), 1, 1e-6);
  EXPECT_NEAR(weightOfFirstHalf(particles), before, 1e-6);
}

TEST_P(EveryMethod, EqualModesStayEqualOverAThousandResamplings)
{
  ParticleSet particles = onALine(std::vector<double>(1000, 1.0));
  RandomStream random(7);
  for (int k = 0; k < 1000; ++k) particles = resampleByMode(particles, halves(particles), GetParam(), 200, random);
  EXPECT_NEAR(weightOfFirstHalf(particles), 0.5, 1e-6);
}

TEST(Resampling, WithoutModesEqualModesDriftApart)
{
  RandomStream random(8);
  int died = 0;
  for (int run = 0; run < 20; ++run)
  {
    ParticleSet particles = onALine(std::vector<double>(1000, 1.0));
    for (int k = 0; k < 1000; ++k)
      particles = select(particles, drawIndices(ResamplingMethod::multinomial, weights(particles), 200, random));
    const double share = weightOfFirstHalf(particles);
    died += share < 1e-6 || share > 1 - 1e-6 ? 1 : 0;
  }
  EXPECT_GE(died, 15);
}

TEST(Resampling, SystematicCountsAreRoundedExpectations)
{
  rc::check("each count is the floor or the ceiling of its expectation",
            [](const std::vector<unsigned>& raw, std::uint64_t seed)
            {
              std::vector<double> w;
              for (const unsigned v : raw) w.push_back(v % 1000);
              const double sum = std::accumulate(w.begin(), w.end(), 0.0);
              RC_PRE(sum > 0);
              const std::size_t count = 1 + seed % 97;
              RandomStream random(seed);
              const auto drawn = counts(drawIndices(ResamplingMethod::systematic, w, count, random), w.size());
              for (std::size_t i = 0; i < w.size(); ++i)
              {
                const double expected = static_cast<double>(count) * w[i] / sum;
                RC_ASSERT(static_cast<double>(drawn[i]) >= std::floor(expected - 1e-9));
                RC_ASSERT(static_cast<double>(drawn[i]) <= std::ceil(expected + 1e-9));
              }
            });
}

TEST(Resampling, AllotmentsAreRoundedExpectationsAndSumToTheCount)
{
  rc::check("each allotment is the floor or the ceiling of its expectation",
            [](const std::vector<unsigned>& raw, std::uint64_t seed)
            {
              std::vector<double> w;
              for (const unsigned v : raw) w.push_back(v % 1000);
              const double sum = std::accumulate(w.begin(), w.end(), 0.0);
              RC_PRE(sum > 0);
              const std::size_t count = 1 + seed % 9973;
              RandomStream random(seed);
              const auto allotted = allotSystematically(w, count, random);
              RC_ASSERT(std::accumulate(allotted.begin(), allotted.end(), std::size_t{0}) == count);
              for (std::size_t i = 0; i < w.size(); ++i)
              {
                const double expected = static_cast<double>(count) * w[i] / sum;
                RC_ASSERT(static_cast<double>(allotted[i]) >= std::floor(expected - 1e-9));
                RC_ASSERT(static_cast<double>(allotted[i]) <= std::ceil(expected + 1e-9));
              }
            });
}

TEST(Resampling, StratifiedDrawsOnePerStratum)
{
  RandomStream random(9);
  const std::vector<double> w{0.13, 0.22, 0.05, 0.35, 0.25};
  for (int k = 0; k < 1000; ++k)
  {
    const auto drawn = counts(drawIndices(ResamplingMethod::stratified, w, 20, random), w.size());
    for (std::size_t i = 0; i < w.size(); ++i) EXPECT_LT(std::abs(static_cast<double>(drawn[i]) - 20 * w[i]), 2);
  }
}

TEST(Resampling, ResidualTakesWholeExpectationsForCertain)
{
  RandomStream random(10);
  for (const std::size_t size : {3, 10, 49, 1000})
  {
    const std::vector<double> equal(size, 1.0 / static_cast<double>(size) * 0.999999);
    for (const std::size_t drawn : counts(drawIndices(ResamplingMethod::residual, equal, 3 * size, random), size))
      EXPECT_EQ(drawn, 3u);
  }
}

TEST(Resampling, AVeryLightModeKeepsItsExpectedWeight)
{
  // 1 particle of weight 0.002 in a mode of its own, 100 drawn: it survives once in five, and must then weigh more.
  const int repeats = 20000;
  const double light = 0.002;
  ParticleSet particles;
  for (int i = 0; i < 100; ++i) particles.add({0, 0, 0}, std::log((1 - light) / 100));
  particles.add({1000, 0, 0}, std::log(light));
  RandomStream random(11);
  double mean = 0;
  for (int k = 0; k < repeats; ++k)
    mean +=
        1 - weightOfFirstHalf(resampleByMode(particles, halves(particles), ResamplingMethod::systematic, 100, random));
  mean /= repeats;
  EXPECT_NEAR(mean, light, 4 * std::sqrt(light * 0.01 / repeats) + 0.02 * light);
}

TEST(Resampling, ACloudOfSingleParticleModesKeepsItsDistribution)
{
  // Every particle is a mode; weights rise linearly, so the mean of x is 2/3 of the length.
  const std::size_t n = 5000;
  ParticleSet particles;
  std::vector<int> mode_of;
  for (std::size_t i = 0; i < n; ++i)
  {
    particles.add({static_cast<double>(i) / n, 0, 0}, std::log(static_cast<double>(i) + 0.5));
    mode_of.push_back(static_cast<int>(i));
  }
  normalizeWeights(particles);
  RandomStream random(12);
  const ParticleSet drawn = resampleByMode(particles, mode_of, ResamplingMethod::systematic, 500, random);
  double mean = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) mean += std::exp(double{drawn.log_weight[i]}) * double{drawn.x[i]};
  EXPECT_NEAR(mean, 2.0 / 3, 0.01);
}

TEST(Resampling, ResamplesNoParticlesToNone)
{
  RandomStream random(13);
  EXPECT_TRUE(resampleByMode({}, {}, ResamplingMethod::systematic, 100, random).empty());
}
}  // namespace mrpt_ext::test_resampling
