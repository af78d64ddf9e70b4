#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// What became of one detection.
struct DetectionUse
{
  std::size_t reading = 0, detection = 0;  ///< positions in the frame's scored readings
  std::optional<std::size_t> landmark;     ///< that it was taken for; absent: not used
  double explained = 0;                    ///< probability that it shows any landmark and is no clutter
};

struct KalmanUpdate
{
  KalmanState state;
  double log_evidence = 0;     ///< of everything measured, clutter included
  double nis = 0;              ///< normalised innovation squared, summed over the measurements used
  int degrees_of_freedom = 0;  ///< ... whose number this is: what nis is on average
  bool compass_used = false;
  std::vector<DetectionUse> detections;  ///< in the order in which they were taken in
};

/// Bayes' rule for one frame by the extended Kalman filter.
///
/// Detections enter one after the other, linearised at the state that those before have left. Each is a mixture, as for
/// particles: p(z) = (1 - e) sum_j s_j N(z; h_j, H_j P H_j^T + R_j) + e / V, with e the clutter probability, V the
/// volume of the measurement space and s_j the share of landmark j among those the detection may show. The product of
/// the p(z) is the evidence: comparable between states that saw the same frames, whatever they took for what. A
/// detection is used, with full weight, for the landmark it shows more likely than everything else together (clutter
/// and other landmarks); otherwise it is left out. Where names are missing, the surest detections come first, so that
/// they narrow the choice for the others (sequential compatibility; no two detections are forbidden to show the same
/// landmark, as in the likelihood of particles). Landmarks that were not reported count in the evidence where the
/// reading declares what it sees (missed_detections.h).
/// The covariance is updated in Joseph's form and stays positive definite.
[[nodiscard]] KalmanUpdate updateExtended(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                                          const BiasModel& biases);

/// The same, and then the state is moved to the maximum of the posterior of what was used (Bell and Cathey, "The
/// iterated Kalman filter update as a Gauss-Newton method", IEEE Trans. Autom. Control 38(2), 1993), with the
/// covariance linearised there. A step that does not lower the cost is halved. Evidence and choices are those of
/// updateExtended().
[[nodiscard]] KalmanUpdate updateIterated(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                                          const BiasModel& biases);
}  // namespace mrpt_ext
