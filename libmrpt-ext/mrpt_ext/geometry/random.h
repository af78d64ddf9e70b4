#pragma once

#include <array>
#include <cstdint>

namespace mrpt_ext
{
/// Random numbers that are the same on every platform and for every number of threads.
///
/// Generator: xoshiro256++ (Blackman, Vigna 2019). Its state is filled by splitmix64 from a hash of (seed, stream), so
/// that every stream of one seed is a sequence of its own: give each trial, sensor or particle block its own stream
/// number, never share an object between threads. Gaussians: ziggurat with 128 layers (Marsaglia, Tsang 2000; exact
/// tail and 53-bit mantissa as in Doornik 2005), because std::normal_distribution differs between standard libraries.
class RandomStream
{
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0);

  /// 64 random bits.
  std::uint64_t nextBits()
  {
    const std::uint64_t result = rotate(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(nextBits() >> 11) * 0x1p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Standard normal deviate.
  double gaussian()
  {
    const std::uint64_t bits = nextBits();
    const std::size_t layer = bits & 127;
    const double u = static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
    const double x = u * kZiggurat.edge[layer];
    return (u < 0 ? -u : u) < kZiggurat.ratio[layer] ? x : gaussianOutsideCore(layer, x);
  }

  /// True with this probability; a draw is made also for 0 and 1.
  bool chance(double probability) { return uniform() < probability; }
  /// Uniform in {0, ..., count - 1}; 0 when count is 0.
  std::uint64_t below(std::uint64_t count);
  /// Number of events with this mean (Poisson); 0 for a mean that is not positive.
  int poisson(double mean);

 private:
  struct Ziggurat
  {
    std::array<double, 129> edge;   ///< right edge of each layer, decreasing
    std::array<double, 128> ratio;  ///< edge[i + 1] / edge[i]: inside it a point is below the curve
    Ziggurat();
  };
  static const Ziggurat kZiggurat;

  static constexpr std::uint64_t rotate(std::uint64_t v, int by) { return (v << by) | (v >> (64 - by)); }
  double gaussianOutsideCore(std::size_t layer, double x);
  double gaussianTail(bool negative);

  std::array<std::uint64_t, 4> state_;
};
}  // namespace mrpt_ext
