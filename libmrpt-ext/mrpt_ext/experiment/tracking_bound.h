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
  std::string why_none;  ///< why there is no bound, for people; empty where there is one
};

/// The bound along the true trajectory with the configured models (of the particle filter): initial deviations (of the
/// box of possible poses where the start is not told), noise of odometry for the way that was driven, deviations of the
/// detections and of the map. Systematic errors count as known, which makes the bound lower where they have to be
/// found. Detections that are more than five standard deviations from what the true pose predicts are false and tell
/// nothing. Needs a true pose with heading at every frame and a name on every detection, since the true associations
/// are not known otherwise.
[[nodiscard]] TrackingBound trackingBound(const RunContext& context, const ParticleFilterOptions& filter,
                                          const OdometryPath& odometry, const FrameFeed& frames);

/// Root of the mean over the stamps from `from` on: what a method's RMSE over the same stamps is compared with.
/// No stamp: no figures.
[[nodiscard]] LimitScore limitFrom(const TrackingBound& bound, double from);
}  // namespace mrpt_ext
