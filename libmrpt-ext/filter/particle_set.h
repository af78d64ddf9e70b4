#pragma once

#include <vector>

#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Weighted robot poses as a structure of arrays: x, y [m], phi [rad], natural logarithm of the weight.
struct ParticleSet
{
  std::vector<double> x, y, phi, log_weight;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  [[nodiscard]] PoseBatch poses() const { return {x, y, phi}; }
  [[nodiscard]] Pose2 pose(std::size_t i) const { return {x[i], y[i], phi[i]}; }
  void add(const Pose2& pose, double log_w);
  void clear();
  void reserve(std::size_t count);
};

/// Scales the weights to sum 1 and returns the logarithm of what they summed to before. If that is not a positive
/// number, all weights become equal.
double normalizeWeights(ParticleSet& particles);

/// Effective sample size 1 / sum w^2 of normalised weights, as a share of the particle count, in (0, 1].
[[nodiscard]] double effectiveSampleRatio(const ParticleSet& particles);

/// The weights themselves (normalised particles).
[[nodiscard]] std::vector<double> weights(const ParticleSet& particles);

/// The particles named by `indices` with equal weights summing to 1.
[[nodiscard]] ParticleSet select(const ParticleSet& particles, const std::vector<std::size_t>& indices);
}  // namespace mrpt_ext
