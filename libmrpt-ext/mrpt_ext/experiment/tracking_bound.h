#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"
#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/frames/frame_synchronizer.h"

namespace mrpt_ext
{
/// Posterior Cramer-Rao bound of a robot that is tracked, at the stamps at which methods are scored.
struct TrackingBound
{
  struct Stamp
  {
    double time = 0;               ///< [s]
    double position_variance = 0;  ///< [m^2] both axes together
    double heading_variance = 0;   ///< [rad^2]
  };
  std::vector<Stamp> stamps;
  std::string why_none;  ///< why there is no bound; empty where there is one, and for anonymous detections
};

/// The bound along the true trajectory with the configured models (of the particle filter): initial covariance (that of
/// the box of possible poses where the start is unknown), noise of odometry along the true trajectory, standard
/// deviations of the detections and of the map. Systematic errors count as known, which lowers the bound where they
/// must be estimated. Detections more than five standard deviations from the prediction at the true pose are outliers
/// without information; there is no bound where most are, as with an offset of a sensor that is not configured. Needs a
/// true pose with heading at every frame, and only identified detections: the true associations of anonymous ones are
/// not known.
[[nodiscard]] TrackingBound trackingBound(const RunContext& context, const ParticleFilterOptions& filter,
                                          const OdometryPath& odometry, const FrameStream& frames);

/// Root of the mean over the stamps from `from` on, for comparison with a method's RMSE over the same stamps; absent
/// without a stamp.
[[nodiscard]] LimitScore limitFrom(const TrackingBound& bound, double from);
}  // namespace mrpt_ext
