#include "mrpt_ext/filter/joint_regularization.h"

#include "mrpt_ext/filter/particle_moments.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRegularizedGate = 4;  // standard deviations that the particles of a mode are within
constexpr int kNoMode = -1;

/// The nearest mode of each particle, if it is within the gate.
std::vector<int> nearestModes(const ParticleSet& particles, const std::vector<Mode>& modes)
{
  std::vector<PoseGate> gates;
  for (const Mode& mode : modes)
    gates.emplace_back(KalmanState{mode.pose.mean.vector(), mode.pose.covariance}, kRegularizedGate);
  std::vector<int> nearest(particles.size(), kNoMode);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    double least = kRegularizedGate * kRegularizedGate;
    for (std::size_t m = 0; m < gates.size(); ++m)
      if (const double distance2 = gates[m].distance2(particles, i); distance2 < least)
      {
        least = distance2;
        nearest[i] = static_cast<int>(m);
      }
  }
  return nearest;
}
}  // namespace

void regularizeJointly(ParticleSet& particles, const std::vector<Mode>& compact, double bandwidth, RandomStream& random)
{
  const std::vector<int> nearest = nearestModes(particles, compact);
  const double keep = std::sqrt(1 - square(bandwidth));
  for (int m = 0; m < static_cast<int>(compact.size()); ++m)
  {
    const auto state = momentsOf(particles, [&](std::size_t i) { return nearest[i] == m; });
    if (!state) continue;
    const GaussianDensity density(*state);
    KalmanVector noise(state->mean.size());
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      if (nearest[i] != m) continue;
      KalmanVector offset = pointOf(particles, i) - state->mean;
      offset[2] = wrap(offset[2]);
      for (double& value : noise) value = random.gaussian();
      setPoint(particles, i, moved(state->mean, keep * offset + bandwidth * density.factor() * noise));
    }
  }
}
}  // namespace mrpt_ext
