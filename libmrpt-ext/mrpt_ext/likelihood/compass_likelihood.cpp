#include "mrpt_ext/likelihood/compass_likelihood.h"

namespace mrpt_ext
{
void addCompassLogLikelihood(const CompassRecord& compass, const PoseBatch& robots, std::span<float> log_likelihood)
{
  constexpr double kClutter = 0.05;  // iron nearby
  const double norm = 1 / (compass.std_heading * std::sqrt(kTwoPi));
  for (std::size_t i = 0; i < robots.size(); ++i)
  {
    const double residual = wrap(compass.heading - double{robots.phi[i]}) / compass.std_heading;
    const double density = (1 - kClutter) * norm * std::exp(-0.5 * square(residual)) + kClutter / kTwoPi;
    log_likelihood[i] += static_cast<float>(std::log(density));
  }
}
}  // namespace mrpt_ext
