#include "mrpt_ext/filter/particles/spaced_draws.h"

#include <array>
#include <numeric>
#include <span>

#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/particles/weight_kernels.h"

namespace mrpt_ext
{
namespace
{
/// Weights of the particles of one block, and their sum.
struct BlockWeights
{
  BlockWeights(const ParticleSet& particles, std::size_t first, std::size_t count)
      : sum(exponentials(std::span(particles.log_weight).subspan(first, count), 0, std::span(weight).first(count)))
  {
  }
  std::array<float, kParticleBlock> weight;
  double sum;
};
}  // namespace

std::vector<std::size_t> spacedDraws(const ParticleSet& particles, std::size_t draws_wanted, unsigned threads)
{
  std::vector<double> before(blockCount(particles.size()) + 1, 0.0);  // sums of all blocks before each one
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               { before[first / kParticleBlock + 1] = BlockWeights(particles, first, count).sum; });
  std::partial_sum(before.begin(), before.end(), before.begin());
  const auto wanted = [&](std::size_t draw)
  { return (static_cast<double>(draw) + 0.5) / static_cast<double>(draws_wanted) * before.back(); };
  std::vector<std::size_t> draws(draws_wanted, 0);
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 const double start = before[first / kParticleBlock], end = before[first / kParticleBlock + 1];
                 std::size_t draw = 0;
                 while (draw < draws_wanted && wanted(draw) < start) ++draw;
                 if (draw == draws_wanted || wanted(draw) >= end) return;
                 const BlockWeights weights(particles, first, count);
                 double reached = start;
                 for (std::size_t i = 0; i < count && draw < draws_wanted && wanted(draw) < end; ++i)
                 {
                   reached += double{weights.weight[i]};
                   // The last one takes what rounding leaves.
                   for (; draw < draws_wanted && wanted(draw) < (i + 1 < count ? reached : end); ++draw)
                     draws[draw] = first + i;
                 }
               });
  if (particles.empty()) draws.clear();
  return draws;
}
}  // namespace mrpt_ext
