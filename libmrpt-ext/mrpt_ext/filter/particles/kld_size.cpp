#include "mrpt_ext/filter/particles/kld_size.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>

namespace mrpt_ext
{
double kldSampleSize(std::size_t bins, double epsilon, double delta)
{
  if (bins < 2) return 1;
  const double k = static_cast<double>(bins - 1);
  const double z = boost::math::quantile(boost::math::normal(), 1 - delta);
  const double a = 2 / (9 * k);
  return k / (2 * epsilon) * std::pow(1 - a + std::sqrt(a) * z, 3);
}

std::size_t occupiedBins(const ParticleSet& particles, const KldOptions& options)
{
  const auto turns = std::max<std::int64_t>(1, std::llround(kTwoPi / options.bin_phi));
  std::vector<std::array<std::int64_t, 3>> bins(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Pose2 pose = particles.pose(i);
    const double turned = (pose.phi + kPi) / kTwoPi * static_cast<double>(turns);
    bins[i] = {static_cast<std::int64_t>(std::floor(pose.x / options.bin_xy)),
               static_cast<std::int64_t>(std::floor(pose.y / options.bin_xy)),
               static_cast<std::int64_t>(std::floor(turned)) % turns};
  }
  std::sort(bins.begin(), bins.end());
  return static_cast<std::size_t>(std::unique(bins.begin(), bins.end()) - bins.begin());
}
}  // namespace mrpt_ext
