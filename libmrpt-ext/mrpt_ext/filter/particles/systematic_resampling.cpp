#include "mrpt_ext/filter/particles/systematic_resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/particles/weight_kernels.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxSums = 1 << 20;

/// Points k + offset, k = 0, 1, ... `count` - 1, on a line of the mode's cumulative weights, scaled so that
/// they reach `count`.
struct ModePoints
{
  std::size_t count = 0, first = 0;  ///< number of its survivors, and index of the first one in the result
  double scale = 0, offset = 0;
  float log_weight = 0;  ///< of each survivor

  /// Number of points below `sum` of the weights.
  [[nodiscard]] std::size_t below(double sum) const
  {
    return std::min(count, static_cast<std::size_t>(static_cast<std::int64_t>(sum * scale + (1 - offset))));
  }
};

std::vector<ModePoints> pointsOf(const std::vector<double>& mode_weight, std::size_t count, RandomStream& random)
{
  std::vector<ModePoints> points(mode_weight.size());
  const std::vector<std::size_t> allotted = allotSystematically(mode_weight, count, random);
  const double total = std::accumulate(mode_weight.begin(), mode_weight.end(), 0.0);
  double sum = 0;
  const auto represented = [&](std::size_t mode)
  {
    // A mode that expects less than one particle gets one at random, which then represents the times it got none.
    return std::max(mode_weight[mode], total / static_cast<double>(count));
  };
  std::size_t first = 0;
  for (std::size_t mode = 0; mode < points.size(); ++mode)
  {
    ModePoints& p = points[mode];
    p.count = allotted[mode];
    p.first = first;
    first += p.count;
    if (p.count == 0) continue;
    p.scale = static_cast<double>(p.count) / mode_weight[mode];
    p.offset = std::min(random.uniform(), 1 - 1e-6);  // the last point stays below the end in spite of rounding
    sum += represented(mode);
  }
  for (std::size_t mode = 0; mode < points.size(); ++mode)
    if (points[mode].count > 0)
      points[mode].log_weight =
          static_cast<float>(std::log(represented(mode) / (sum * static_cast<double>(points[mode].count))));
  return points;
}

ParticleSet resized(ParticleSet buffer, std::size_t count, const ParticleSet& particles)
{
  buffer.origin = particles.origin;
  buffer.bias_states = particles.bias_states;
  buffer.bias.resize(particles.bias.size());
  buffer.resize(count);
  return buffer;
}

/// The weights of one block, and their sums per mode as both walks through them add them up.
class WeightBlocks
{
 public:
  WeightBlocks(const ParticleSet& particles, const std::vector<int>& mode_of, std::size_t first, std::size_t count)
      : modes_(mode_of.data() + first), count_(count)
  {
    exponentials(std::span(particles.log_weight).subspan(first, count), 0, std::span(weight_).first(count));
  }

  /// Adds to sums[mode], particle after particle, and calls `visit(particle of the block, mode, sum so far)`.
  template <typename Visit>
  void accumulate(std::span<double> sums, Visit&& visit) const
  {
    for (std::size_t i = 0; i < count_;)
    {
      const int mode = modes_[i];
      double sum = sums[static_cast<std::size_t>(mode)];  // in a register: neighbours are mostly of one mode
      for (; i < count_ && modes_[i] == mode; ++i)
      {
        sum += double{weight_[i]};
        visit(i, static_cast<std::size_t>(mode), sum);
      }
      sums[static_cast<std::size_t>(mode)] = sum;
    }
  }

 private:
  const int* modes_;
  std::size_t count_;
  alignas(64) float weight_[kParticleBlock];
};

/// Copies survivors of one block. Their numbers are collected first, then each column is copied by itself: that is
/// easier on the cache than all columns at once.
class Survivors
{
 public:
  Survivors(const ParticleSet& particles, std::size_t first, ParticleSet& result)
      : particles_(particles), result_(result), first_(first)
  {
  }

  /// The survivors [from, to) of a mode are copies of a particle of the block.
  void put(std::size_t particle, const ModePoints& mode, std::size_t from, std::size_t to)
  {
    if (&mode != mode_ || to - from_ > kRoom) begin(mode, from);
    for (; to - from > kRoom; from += kRoom, begin(mode, from)) note(particle, kRoom);
    note(particle, to - from);
  }

  void copy()
  {
    if (count_ == 0) return;
    copyColumn(particles_.x, result_.x);
    copyColumn(particles_.y, result_.y);
    copyColumn(particles_.phi, result_.phi);
    for (std::size_t k = 0; k < result_.bias.size(); ++k) copyColumn(particles_.bias[k], result_.bias[k]);
    std::fill_n(result_.log_weight.begin() + static_cast<std::ptrdiff_t>(mode_->first + from_), count_,
                mode_->log_weight);
    count_ = 0;
  }

 private:
  static constexpr std::size_t kRoom = 2048, kAtOnce = 8;

  void begin(const ModePoints& mode, std::size_t from)
  {
    copy();
    mode_ = &mode;
    from_ = from;
  }

  /// Always writes several, which is faster than a loop of the right length: the next ones overwrite the excess.
  void note(std::size_t particle, std::size_t times)
  {
    const auto number = static_cast<std::uint32_t>(particle);
    std::uint32_t* at = numbers_ + count_;
    for (std::size_t k = 0; k < kAtOnce; ++k) at[k] = number;
    for (std::size_t k = kAtOnce; k < times; ++k) at[k] = number;
    count_ += times;
  }

  void copyColumn(const std::vector<float>& from, std::vector<float>& to) const
  {
    const float* in = from.data() + first_;
    float* out = to.data() + mode_->first + from_;
    for (std::size_t k = 0; k < count_; ++k) out[k] = in[numbers_[k]];
  }

  const ParticleSet& particles_;
  ParticleSet& result_;
  const ModePoints* mode_ = nullptr;          // whose survivors are collected, ...
  std::size_t first_, from_ = 0, count_ = 0;  // ... and which ones
  std::uint32_t numbers_[kRoom + kAtOnce];
};

void copySurvivors(const ParticleSet& particles, const WeightBlocks& weights, std::size_t first,
                   std::span<const ModePoints> points, std::span<const double> sums_before, ParticleSet& result)
{
  std::vector<double> sums(points.size(), 0.0);
  std::vector<std::size_t> next(points.size());
  for (std::size_t mode = 0; mode < points.size(); ++mode) next[mode] = points[mode].below(sums_before[mode]);
  Survivors survivors(particles, first, result);
  weights.accumulate(sums,
                     [&](std::size_t i, std::size_t mode, double sum)
                     {
                       const ModePoints& p = points[mode];
                       const std::size_t from = std::exchange(next[mode], p.below(sums_before[mode] + sum));
                       survivors.put(i, p, from, next[mode]);
                     });
  survivors.copy();
}
}  // namespace

std::vector<std::size_t> allotSystematically(const std::vector<double>& weights, std::size_t count,
                                             RandomStream& random)
{
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0), offset = random.uniform();
  std::vector<std::size_t> allotted(weights.size(), 0);
  double cumulative = 0;
  std::size_t given = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    cumulative += weights[i];
    // The points (k + offset) sum / count lie one in each equal part of the line of weights.
    const double below = static_cast<double>(count) * cumulative / sum + (1 - offset);
    const std::size_t reached = std::clamp(static_cast<std::size_t>(below), given, count);
    allotted[i] = reached - given;
    given = reached;
  }
  return allotted;
}

std::optional<ParticleSet> resampleSystematically(const ParticleSet& particles, const std::vector<int>& mode_of,
                                                  std::size_t count, RandomStream& random, unsigned threads,
                                                  ParticleSet buffer)
{
  const std::size_t blocks = blockCount(particles.size());
  const auto modes =
      static_cast<std::size_t>(mode_of.empty() ? 0 : *std::max_element(mode_of.begin(), mode_of.end()) + 1);
  if (count == 0 || modes == 0 || modes * blocks > kMaxSums) return std::nullopt;

  std::vector<double> before((blocks + 1) * modes, 0.0);  // sums per mode of all blocks before each one
  const auto sums_before = [&](std::size_t block) { return std::span(before).subspan(block * modes, modes); };
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t size)
               {
                 WeightBlocks(particles, mode_of, first, size)
                     .accumulate(sums_before(first / kParticleBlock + 1), [](std::size_t, std::size_t, double) {});
               });
  for (std::size_t k = modes; k < before.size(); ++k) before[k] += before[k - modes];
  const std::vector<double> mode_weight(before.end() - static_cast<std::ptrdiff_t>(modes), before.end());
  if (!(std::accumulate(mode_weight.begin(), mode_weight.end(), 0.0) > 0)) return std::nullopt;

  const std::vector<ModePoints> points = pointsOf(mode_weight, count, random);
  ParticleSet result = resized(std::move(buffer), count, particles);
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t size)
               {
                 copySurvivors(particles, WeightBlocks(particles, mode_of, first, size), first, points,
                               sums_before(first / kParticleBlock), result);
               });
  return result;
}
}  // namespace mrpt_ext
