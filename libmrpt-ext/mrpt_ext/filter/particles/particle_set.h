#pragma once

#include <vector>

#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Weighted robot poses as a structure of arrays: x, y [m] from `origin`, phi [rad], natural logarithm of the weight.
/// Single precision throughout: 16 bytes per particle, 4 more for every systematic error that is estimated with the
/// pose.
struct ParticleSet
{
  ParticleSet() = default;
  /// No particles yet; `set_origin` [m, map frame] ideally in the middle of their poses.
  explicit ParticleSet(const Vector2d& set_origin, BiasModel biases = {})
      : origin(set_origin), bias_states(std::move(biases)), bias(bias_states.size())
  {
  }

  Vector2d origin{0, 0};
  std::vector<float> x, y, phi, log_weight;
  BiasModel bias_states;
  std::vector<std::vector<float>> bias;  ///< one column per bias state

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
  [[nodiscard]] PoseBatch poses() const;
  /// In the map frame, heading wrapped.
  [[nodiscard]] Pose2 pose(std::size_t i) const
  {
    return {origin.x() + double{x[i]}, origin.y() + double{y[i]}, wrap(double{phi[i]})};
  }
  void setPose(std::size_t i, const Pose2& pose);
  /// A particle whose systematic errors are their means.
  void add(const Pose2& pose, double log_w);
  /// Particle i of a set with the same origin and bias states, with another weight.
  void addCopy(const ParticleSet& from, std::size_t i, double log_w);
  void clear();
  void reserve(std::size_t count);
  /// To `count` particles; new ones are uninitialized.
  void resize(std::size_t count);
  /// An empty set with the same origin and bias states.
  [[nodiscard]] ParticleSet emptyLikeThis() const { return ParticleSet(origin, bias_states); }
};

struct Normalization
{
  double log_sum = 0;          ///< logarithm of the sum of the weights before
  double effective_ratio = 0;  ///< effective sample size 1 / sum w^2 over the particle count, in (0, 1]
};

/// Scales the weights to sum 1. If what they sum to is not a positive number, all weights become equal.
/// `threads` change nothing but the time.
Normalization normalizeWeights(ParticleSet& particles, unsigned threads = 1);

/// The weights themselves (normalised particles).
[[nodiscard]] std::vector<double> weights(const ParticleSet& particles);

/// The particles at `indices` with equal weights summing to 1.
[[nodiscard]] ParticleSet select(const ParticleSet& particles, const std::vector<std::size_t>& indices);
}  // namespace mrpt_ext
