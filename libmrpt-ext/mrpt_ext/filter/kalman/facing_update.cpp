#include "mrpt_ext/filter/kalman/facing_update.h"

#include <array>

#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"

namespace mrpt_ext
{
namespace
{
KalmanRow rowOf(const Facing::Attitude& heading, const Reading& reading, const KalmanVector& mean,
                const BiasModel& biases)
{
  KalmanRow row = lineariseHeading(heading.yaw, heading.std, mean);
  // The sensor's offset turns what is seen, and with it the heading that follows, the other way.
  for (std::size_t k = 0; k < biases.size(); ++k)
    if (biases[k].kind == BiasKind::bearing_offset && actsOn(biases[k], reading.sensor))
    {
      const auto index = 3 + static_cast<Eigen::Index>(k);
      row.jacobian[index] = -1;
      row.residual = wrap(row.residual + mean[index]);
    }
  return row;
}
}  // namespace

std::optional<FacingInnovation> compareFacing(const Detection& detection, const Reading& reading,
                                              const LandmarkTable& map, const KalmanState& state,
                                              const BiasModel& biases)
{
  const auto headings = headingFromFacing(detection, reading, map);
  if (!headings) return std::nullopt;
  std::array<double, 2> densities{}, nis{};
  for (std::size_t k = 0; k < densities.size(); ++k)
  {
    const Facing::Attitude& heading = headings->attitudes[k];
    if (!(heading.weight > 0)) continue;
    const KalmanRow row = rowOf(heading, reading, state.mean, biases);
    const Innovation innovation = innovationOf({&row, 1}, state.covariance);
    densities[k] = heading.weight * std::exp(innovation.log_density);
    nis[k] = innovation.nis;
  }
  const double clutter = boundedClutter(reading.model.clutter_probability), both = densities[0] + densities[1];
  const std::size_t likelier = densities[1] > densities[0] ? 1 : 0;
  FacingInnovation result{.evidence = (1 - clutter) * both + clutter / kTwoPi};
  if (densities[likelier] >= kCertainAttitude * both && (1 - clutter) * both > clutter / kTwoPi)
    result.attitude = likelier, result.nis = nis[likelier];
  return result;
}

KalmanRow lineariseFacing(const Detection& detection, std::size_t attitude, const Reading& reading,
                          const LandmarkTable& map, const KalmanVector& mean, const BiasModel& biases)
{
  return rowOf(headingFromFacing(detection, reading, map).value().attitudes[attitude], reading, mean, biases);
}
}  // namespace mrpt_ext
