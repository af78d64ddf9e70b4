#include "mrpt_ext/filter/particle_set.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
void ParticleSet::add(const Pose2& pose, double log_w)
{
  x.push_back(pose.x);
  y.push_back(pose.y);
  phi.push_back(pose.phi);
  log_weight.push_back(log_w);
}

void ParticleSet::clear()
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->clear();
}

void ParticleSet::reserve(std::size_t count)
{
  for (auto* column : {&x, &y, &phi, &log_weight}) column->reserve(count);
}

double normalizeWeights(ParticleSet& particles)
{
  if (particles.empty()) return 0;
  const double best = *std::max_element(particles.log_weight.begin(), particles.log_weight.end());
  if (!std::isfinite(best))  // no particle is possible: nothing tells them apart
  {
    std::fill(particles.log_weight.begin(), particles.log_weight.end(),
              -std::log(static_cast<double>(particles.size())));
    return best;
  }
  double sum = 0;
  for (const double log_w : particles.log_weight) sum += std::exp(log_w - best);
  const double log_sum = best + std::log(sum);
  for (double& log_w : particles.log_weight) log_w -= log_sum;
  return log_sum;
}

double effectiveSampleRatio(const ParticleSet& particles)
{
  double sum2 = 0;
  for (const double log_w : particles.log_weight) sum2 += std::exp(2 * log_w);
  return particles.empty() ? 0.0 : 1 / (sum2 * static_cast<double>(particles.size()));
}

std::vector<double> weights(const ParticleSet& particles)
{
  std::vector<double> result(particles.size());
  std::transform(particles.log_weight.begin(), particles.log_weight.end(), result.begin(),
                 [](double log_w) { return std::exp(log_w); });
  return result;
}

ParticleSet select(const ParticleSet& particles, const std::vector<std::size_t>& indices)
{
  ParticleSet result;
  result.reserve(indices.size());
  const double log_w = -std::log(static_cast<double>(std::max<std::size_t>(indices.size(), 1)));
  for (const std::size_t i : indices) result.add(particles.pose(i), log_w);
  return result;
}
}  // namespace mrpt_ext
