#include "mrpt_ext/filter/systematic_resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mrpt_ext/filter/particle_blocks.h"
#include "mrpt_ext/filter/resampling.h"
#include "mrpt_ext/filter/weight_kernels.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxSums = 1 << 20;

/// Points k + offset, k = 0, 1, ... `count` - 1, on a line on which the mode's weights lie end to end, scaled so that
/// they reach `count`.
struct ModePoints
{
  std::size_t count = 0, place = 0;  ///< of its survivors: how many, and where the first one goes
  double scale = 0, offset = 0;
  float log_weight = 0;  ///< of each survivor

  [[nodiscard]] bool isBelow(std::size_t k, double reach) const
  {
    return k < count && static_cast<double>(k) + offset < reach;
  }
  /// Number of points below `reach`, by the very comparison that the walk along the line makes.
  [[nodiscard]] std::size_t below(double reach) const
  {
    auto k = static_cast<std::size_t>(std::clamp(std::ceil(reach - offset), 0.0, static_cast<double>(count)));
    while (k > 0 && !isBelow(k - 1, reach)) --k;
    while (isBelow(k, reach)) ++k;
    return k;
  }
};

std::vector<ModePoints> pointsOf(const std::vector<double>& mode_weight, std::size_t count, RandomStream& random)
{
  std::vector<ModePoints> points(mode_weight.size());
  // Systematic allotment: every mode gets its expected number, rounded up or down.
  for (const std::size_t mode : drawIndices(ResamplingMethod::systematic, mode_weight, count, random))
    ++points[mode].count;
  const double total = std::accumulate(mode_weight.begin(), mode_weight.end(), 0.0);
  double sum = 0;
  const auto stands_for = [&](std::size_t mode)
  {
    // A mode that expects less than one particle gets one now and then, and must then stand for the times it got none.
    return std::max(mode_weight[mode], total / static_cast<double>(count));
  };
  std::size_t place = 0;
  for (std::size_t mode = 0; mode < points.size(); ++mode)
  {
    ModePoints& p = points[mode];
    p.place = place;
    place += p.count;
    if (p.count == 0) continue;
    p.scale = static_cast<double>(p.count) / mode_weight[mode];
    p.offset = std::min(random.uniform(), 1 - 1e-9);  // the last point stays below the end in spite of rounding
    sum += stands_for(mode);
  }
  for (std::size_t mode = 0; mode < points.size(); ++mode)
    if (points[mode].count > 0)
      points[mode].log_weight =
          static_cast<float>(std::log(stands_for(mode) / (sum * static_cast<double>(points[mode].count))));
  return points;
}

ParticleSet emptyPlaces(const ParticleSet& particles, std::size_t count)
{
  ParticleSet result = particles.emptyLikeThis();
  for (auto* column : {&result.x, &result.y, &result.phi, &result.log_weight}) column->resize(count);
  for (auto& column : result.bias) column.resize(count);
  return result;
}

void copyTo(ParticleSet& result, std::size_t place, const ParticleSet& particles, std::size_t i, float log_weight)
{
  result.x[place] = particles.x[i];
  result.y[place] = particles.y[i];
  result.phi[place] = particles.phi[i];
  result.log_weight[place] = log_weight;
  for (std::size_t k = 0; k < result.bias.size(); ++k) result.bias[k][place] = particles.bias[k][i];
}
}  // namespace

std::optional<ParticleSet> resampleSystematically(const ParticleSet& particles, const std::vector<int>& mode_of,
                                                  std::size_t count, RandomStream& random, unsigned threads)
{
  const std::size_t blocks = blockCount(particles.size());
  const auto modes =
      static_cast<std::size_t>(mode_of.empty() ? 0 : *std::max_element(mode_of.begin(), mode_of.end()) + 1);
  if (count == 0 || modes == 0 || modes * blocks > kMaxSums) return std::nullopt;

  std::vector<float> weight(particles.size());
  std::vector<double> before(blocks * modes, 0.0);  // first the sums of each block, then those of all before it
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t size)
               {
                 exponentials(std::span(particles.log_weight).subspan(first, size), 0,
                              std::span(weight).subspan(first, size));
                 double* sums = &before[first / kParticleBlock * modes];
                 for (std::size_t i = first; i < first + size; ++i) sums[mode_of[i]] += double{weight[i]};
               });
  std::vector<double> mode_weight(modes, 0.0);
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t mode = 0; mode < modes; ++mode)
    {
      const double own = before[b * modes + mode];
      before[b * modes + mode] = mode_weight[mode];
      mode_weight[mode] += own;
    }
  if (!(std::accumulate(mode_weight.begin(), mode_weight.end(), 0.0) > 0)) return std::nullopt;

  const std::vector<ModePoints> points = pointsOf(mode_weight, count, random);
  ParticleSet result = emptyPlaces(particles, count);
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t size)
               {
                 const double* start = &before[first / kParticleBlock * modes];
                 std::vector<double> sum(modes, 0.0);
                 std::vector<std::size_t> next(modes);
                 for (std::size_t mode = 0; mode < modes; ++mode)
                   next[mode] = points[mode].below(start[mode] * points[mode].scale);
                 for (std::size_t i = first; i < first + size; ++i)
                 {
                   const auto mode = static_cast<std::size_t>(mode_of[i]);
                   const ModePoints& p = points[mode];
                   sum[mode] += double{weight[i]};
                   const double reach = (start[mode] + sum[mode]) * p.scale;
                   for (; p.isBelow(next[mode], reach); ++next[mode])
                     copyTo(result, p.place + next[mode], particles, i, p.log_weight);
                 }
               });
  return result;
}
}  // namespace mrpt_ext
