#include "mrpt_ext/filter/particles/particle_bias.h"

#include <cmath>

namespace mrpt_ext
{
void drawBiases(ParticleSet& particles, std::size_t first, RandomStream& random)
{
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
  {
    const BiasState& state = particles.bias_states[k];
    for (std::size_t i = first; i < particles.size(); ++i)
      particles.bias[k][i] = static_cast<float>(state.mean + state.std * random.gaussian());
  }
}

void walkBiases(ParticleSet& particles, double duration, RandomStream& random)
{
  for (std::size_t k = 0; k < particles.bias.size(); ++k)
  {
    const double std = particles.bias_states[k].std_per_sqrt_s * std::sqrt(duration);
    if (!(std > 0)) continue;
    for (float& value : particles.bias[k]) value += static_cast<float>(std * random.gaussian());
  }
}
}  // namespace mrpt_ext
