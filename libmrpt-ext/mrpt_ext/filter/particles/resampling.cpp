#include "mrpt_ext/filter/particles/resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mrpt_ext/filter/particles/systematic_resampling.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRounding = 1e-9;  // a count this close below a whole number counts as whole

/// Walks once through the cumulative weights: `points` ascending in [0, 1).
void drawAt(const std::vector<double>& weights, double sum, const std::vector<double>& points,
            std::vector<std::size_t>& indices)
{
  std::size_t i = 0;
  double cumulative = weights[0];
  for (const double point : points)
  {
    while (point * sum >= cumulative && i + 1 < weights.size()) cumulative += weights[++i];
    indices.push_back(i);
  }
}

std::vector<double> sortedUniforms(std::size_t count, RandomStream& random)
{
  std::vector<double> points(count);
  for (double& point : points) point = random.uniform();
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<double> spacedPoints(ResamplingMethod method, std::size_t count, RandomStream& random)
{
  std::vector<double> points(count);
  const double common = random.uniform();
  for (std::size_t k = 0; k < count; ++k)
  {
    const double offset = method == ResamplingMethod::systematic ? common : random.uniform();
    points[k] = (static_cast<double>(k) + offset) / static_cast<double>(count);
  }
  return points;
}

std::vector<std::size_t> drawResidual(const std::vector<double>& weights, double sum, std::size_t count,
                                      RandomStream& random)
{
  std::vector<std::size_t> indices;
  std::vector<double> rest(weights.size());
  double rest_sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const double expected = static_cast<double>(count) * weights[i] / sum;
    const double whole = std::floor(expected + kRounding);
    indices.insert(indices.end(), static_cast<std::size_t>(whole), i);
    rest_sum += rest[i] = std::max(0.0, expected - whole);
  }
  if (indices.size() < count && rest_sum > 0)
    drawAt(rest, rest_sum, sortedUniforms(count - indices.size(), random), indices);
  indices.resize(count, indices.empty() ? 0 : indices.back());
  return indices;
}
}  // namespace

std::vector<std::size_t> drawIndices(ResamplingMethod method, const std::vector<double>& weights, std::size_t count,
                                     RandomStream& random)
{
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<std::size_t> indices;
  if (weights.empty() || count == 0 || !(sum > 0)) return indices;
  if (method == ResamplingMethod::residual) return drawResidual(weights, sum, count, random);
  indices.reserve(count);
  const bool multinomial = method == ResamplingMethod::multinomial;
  drawAt(weights, sum, multinomial ? sortedUniforms(count, random) : spacedPoints(method, count, random), indices);
  return indices;
}

ParticleSet resampleByMode(const ParticleSet& particles, const std::vector<int>& mode_of, ResamplingMethod method,
                           std::size_t count, RandomStream& random, unsigned threads, ParticleSet buffer)
{
  if (method == ResamplingMethod::systematic)
    if (auto resampled = resampleSystematically(particles, mode_of, count, random, threads, std::move(buffer)))
      return *std::move(resampled);
  const int modes = mode_of.empty() ? 0 : *std::max_element(mode_of.begin(), mode_of.end()) + 1;
  std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(modes));
  std::vector<double> mode_weight(members.size(), 0.0);
  const std::vector<double> w = weights(particles);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    members[static_cast<std::size_t>(mode_of[i])].push_back(i);
    mode_weight[static_cast<std::size_t>(mode_of[i])] += w[i];
  }
  const std::vector<std::size_t> allotted = allotSystematically(mode_weight, count, random);
  const double total = std::accumulate(mode_weight.begin(), mode_weight.end(), 0.0);
  ParticleSet result = particles.emptyLikeThis();
  result.reserve(count);
  for (std::size_t mode = 0; mode < members.size(); ++mode)
  {
    if (allotted[mode] == 0) continue;
    std::vector<double> member_weights;
    for (const std::size_t i : members[mode]) member_weights.push_back(w[i]);
    // A mode that expects less than one particle gets one at random, which then represents the times it got none.
    const double represented = std::max(mode_weight[mode], total / static_cast<double>(count));
    const double log_w = std::log(represented / static_cast<double>(allotted[mode]));
    for (const std::size_t k : drawIndices(method, member_weights, allotted[mode], random))
      result.addCopy(particles, members[mode][k], log_w);
  }
  normalizeWeights(result);
  return result;
}
}  // namespace mrpt_ext
