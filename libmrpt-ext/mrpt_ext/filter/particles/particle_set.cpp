#include "mrpt_ext/filter/particles/particle_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/particles/weight_kernels.h"

namespace mrpt_ext
{
namespace
{
/// The weights of some particles, relative to the largest one.
struct RelativeSums
{
  float largest = -std::numeric_limits<float>::infinity();
  WeightSums sums;
};

RelativeSums relativeSums(std::span<const float> log_weights)
{
  RelativeSums result{.largest = largestOf(log_weights)};
  if (std::isfinite(result.largest)) result.sums = weightSums(log_weights, result.largest);
  return result;
}

/// Of all blocks together.
RelativeSums combined(const std::vector<RelativeSums>& blocks)
{
  RelativeSums all;
  for (const RelativeSums& block : blocks) all.largest = std::max(all.largest, block.largest);
  if (!std::isfinite(all.largest)) return all;
  for (const RelativeSums& block : blocks)
  {
    const double scale = std::exp(double{block.largest} - double{all.largest});
    all.sums += {scale * block.sums.first, square(scale) * block.sums.second};
  }
  return all;
}

RelativeSums relativeSums(std::span<const float> log_weights, unsigned threads)
{
  std::vector<RelativeSums> blocks(blockCount(log_weights.size()));
  forEachBlock(log_weights.size(), threads,
               [&](std::size_t first, std::size_t count)
               { blocks[first / kParticleBlock] = relativeSums(log_weights.subspan(first, count)); });
  return combined(blocks);
}

double effectiveRatio(const WeightSums& sums, std::size_t count)
{
  return square(sums.first) / (sums.second * static_cast<double>(count));
}
}  // namespace

PoseBatch ParticleSet::poses() const
{
  PoseBatch batch{.origin = origin, .x = x, .y = y, .phi = phi, .bias_states = bias_states};
  for (const auto& column : bias) batch.bias.emplace_back(column);
  return batch;
}

void ParticleSet::setPose(std::size_t i, const Pose2& pose)
{
  x[i] = static_cast<float>(pose.x - origin.x());
  y[i] = static_cast<float>(pose.y - origin.y());
  phi[i] = static_cast<float>(pose.phi);
}

void ParticleSet::add(const Pose2& pose, double log_w)
{
  x.push_back(static_cast<float>(pose.x - origin.x()));
  y.push_back(static_cast<float>(pose.y - origin.y()));
  phi.push_back(static_cast<float>(pose.phi));
  log_weight.push_back(static_cast<float>(log_w));
  for (std::size_t k = 0; k < bias.size(); ++k) bias[k].push_back(static_cast<float>(bias_states[k].mean));
}

void ParticleSet::addCopy(const ParticleSet& from, std::size_t i, double log_w)
{
  x.push_back(from.x[i]);
  y.push_back(from.y[i]);
  phi.push_back(from.phi[i]);
  log_weight.push_back(static_cast<float>(log_w));
  for (std::size_t k = 0; k < bias.size(); ++k) bias[k].push_back(from.bias[k][i]);
}

void ParticleSet::clear()
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->clear();
  for (auto& column : bias) column.clear();
}

void ParticleSet::resize(std::size_t count)
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->resize(count);
  for (auto& column : bias) column.resize(count);
}

void ParticleSet::reserve(std::size_t count)
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->reserve(count);
  for (auto& column : bias) column.reserve(count);
}

Normalization normalizeWeights(ParticleSet& particles, unsigned threads)
{
  if (particles.empty()) return {};
  const std::span<float> logs = particles.log_weight;
  const auto [largest, sums] = relativeSums(logs, threads);
  if (!std::isfinite(largest))  // no particle is possible: nothing tells them apart
  {
    std::fill(logs.begin(), logs.end(), -std::log(static_cast<float>(logs.size())));
    return {largest, 1};
  }
  const double log_sum = std::log(sums.first);
  forEachBlock(logs.size(), threads,
               [&, best = largest](std::size_t first, std::size_t count)
               { subtractAll(logs.subspan(first, count), best, static_cast<float>(log_sum)); });
  return {largest + log_sum, effectiveRatio(sums, logs.size())};
}

std::vector<double> weights(const ParticleSet& particles)
{
  std::vector<float> result(particles.size());
  exponentials(particles.log_weight, 0, result);
  return {result.begin(), result.end()};
}

ParticleSet select(const ParticleSet& particles, const std::vector<std::size_t>& indices)
{
  ParticleSet result = particles.emptyLikeThis();
  result.reserve(indices.size());
  const double log_w = -std::log(static_cast<double>(std::max<std::size_t>(indices.size(), 1)));
  for (const std::size_t i : indices) result.addCopy(particles, i, log_w);
  return result;
}
}  // namespace mrpt_ext
