#include "mrpt_ext/filter/kalman/kalman_association.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_innovation.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
Association associate(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                      const KalmanState& state, const BiasModel& biases, double default_max_range)
{
  const double clutter = std::clamp(reading.model.clutter_probability, kMinClutterProbability, 1.0);
  const bool identified = detection.id != kNoId;
  Association result;
  double view_sum = 0, likelihood_sum = 0, best = 0;
  const auto consider = [&](std::size_t j)
  {
    const DetectionRows rows = linearise(detection, reading, map[j], state.mean, biases);
    const double in_view = identified ? 1.0 : rows.visibility;  // what is identified was in view
    if (!(in_view > 0)) return;
    const Innovation innovation = innovationOf(rowsOf(rows), state.covariance);
    const double likelihood = in_view * std::exp(innovation.log_density);
    view_sum += in_view;
    likelihood_sum += likelihood;
    if (!(likelihood > best)) return;
    best = likelihood;
    result.nis = innovation.nis;
    result.landmark = j;
    result.rows = rows;
  };
  if (identified)
  {
    if (const auto known = map.indexOf(detection.id)) consider(*known);
  }
  else
    for (std::size_t j = 0; j < map.size(); ++j)
      if (mayShow(detection, map[j])) consider(j);

  const double scale = view_sum > 0 ? (1 - clutter) / view_sum : 0;
  const double from_clutter =
      (view_sum > 0 ? clutter : 1.0) / measurementVolume(detection, reading.model, default_max_range);
  result.evidence = scale * likelihood_sum + from_clutter;
  result.inlier_probability = scale * likelihood_sum / result.evidence;
  result.best = scale * best / result.evidence;
  return result;
}
}  // namespace mrpt_ext
