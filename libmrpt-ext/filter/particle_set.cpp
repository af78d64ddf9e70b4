#include "mrpt_ext/filter/particle_set.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/weight_kernels.h"

namespace mrpt_ext
{
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

void ParticleSet::reserve(std::size_t count)
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->reserve(count);
  for (auto& column : bias) column.reserve(count);
}

double normalizeWeights(ParticleSet& particles)
{
  if (particles.empty()) return 0;
  const float best = largestOf(particles.log_weight);
  if (!std::isfinite(best))  // no particle is possible: nothing tells them apart
  {
    std::fill(particles.log_weight.begin(), particles.log_weight.end(),
              -std::log(static_cast<float>(particles.size())));
    return best;
  }
  const double log_sum = std::log(weightSums(particles.log_weight, best).first);
  subtractAll(particles.log_weight, best, static_cast<float>(log_sum));
  return best + log_sum;
}

double effectiveSampleRatio(const ParticleSet& particles)
{
  if (particles.empty()) return 0;
  const WeightSums sums = weightSums(particles.log_weight, 0);
  return square(sums.first) / (sums.second * static_cast<double>(particles.size()));
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
