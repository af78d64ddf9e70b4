#include "mrpt_ext/geometry/random.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kTailStart = 3.442619855899;        // right edge of the lowest full layer
constexpr double kLayerArea = 9.91256303526217e-03;  // area of each of the 128 layers

std::uint64_t splitmix64(std::uint64_t& counter)
{
  std::uint64_t z = (counter += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double bell(double x) { return std::exp(-0.5 * x * x); }
}  // namespace

RandomStream::Ziggurat::Ziggurat()
{
  edge[0] = kLayerArea / bell(kTailStart);
  edge[1] = kTailStart;
  for (std::size_t i = 2; i < 128; ++i)
    edge[i] = std::sqrt(-2.0 * std::log(kLayerArea / edge[i - 1] + bell(edge[i - 1])));
  edge[128] = 0;
  for (std::size_t i = 0; i < 128; ++i) ratio[i] = edge[i + 1] / edge[i];
}

const RandomStream::Ziggurat RandomStream::kZiggurat;

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
{
  // Hashing the seed before the stream is added keeps (seed + 1, stream) and (seed, stream + 1) apart.
  std::uint64_t counter = seed;
  counter = splitmix64(counter) + stream;
  counter = splitmix64(counter);
  for (std::uint64_t& word : state_) word = splitmix64(counter);
}

double RandomStream::gaussianOutsideCore(std::size_t layer, double x)
{
  for (;;)
  {
    if (layer == 0) return gaussianTail(x < 0);
    const double outer = std::exp(-0.5 * (kZiggurat.edge[layer] * kZiggurat.edge[layer] - x * x));
    const double inner = std::exp(-0.5 * (kZiggurat.edge[layer + 1] * kZiggurat.edge[layer + 1] - x * x));
    if (inner + uniform() * (outer - inner) < 1.0) return x;
    const std::uint64_t bits = nextBits();
    layer = bits & 127;
    const double u = static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
    x = u * kZiggurat.edge[layer];
    if (std::abs(u) < kZiggurat.ratio[layer]) return x;
  }
}

double RandomStream::gaussianTail(bool negative)
{
  double beyond, height;
  do {
    beyond = -std::log(1.0 - uniform()) / kTailStart;
    height = -std::log(1.0 - uniform());
  } while (2.0 * height < beyond * beyond);
  return negative ? -(kTailStart + beyond) : kTailStart + beyond;
}

std::uint64_t RandomStream::below(std::uint64_t count)
{
  if (count < 2) return 0;
  const std::uint64_t usable = UINT64_MAX - UINT64_MAX % count;  // rejects the incomplete last cycle: no bias
  std::uint64_t bits = nextBits();
  while (bits >= usable) bits = nextBits();
  return bits % count;
}

int RandomStream::poisson(double mean)
{
  constexpr double kLargestStep = 30.0;  // exp(-mean) must not underflow; Poisson numbers add up
  int events = 0;
  for (; mean > 0; mean -= kLargestStep)
  {
    const double none = std::exp(-std::min(mean, kLargestStep));
    for (double product = uniform(); product > none; product *= uniform()) ++events;
  }
  return events;
}
}  // namespace mrpt_ext
