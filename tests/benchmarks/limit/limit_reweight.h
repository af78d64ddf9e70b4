#pragma once

#include <cstddef>

namespace mrpt_ext::limit
{
/// True where the processor has what the kernels below need (AVX-512 F).
bool canReweight();

/// Robots as columns of equal length, a multiple of 16, on 64-byte boundaries: position, heading as cosine and sine,
/// logarithm of the weight.
struct Robots
{
  const float *x, *y, *cosine, *sine;
  float* log_weight;
  std::size_t count;
};

/// A bearing as a unit vector in the robot frame, and the landmark it shows where that is known.
struct Bearing
{
  float u, v, landmark_x, landmark_y;
};

/// log_weight += kappa * sum over the bearings of (cos(error) - 1): von Mises instead of Gauss, no clutter, no sensor
/// offset, the heading's cosine and sine given. Nothing less can score a bearing.
void reweightKnown(const Robots& robots, const Bearing* bearings, int count, float kappa);

/// The same for ten bearings without a name, each taken as the landmark that fits best, by looking at all of them.
void reweightNearest(const Robots& robots, const Bearing* ten_bearings, const float* landmark_x,
                     const float* landmark_y, int landmarks, float kappa);
}  // namespace mrpt_ext::limit
