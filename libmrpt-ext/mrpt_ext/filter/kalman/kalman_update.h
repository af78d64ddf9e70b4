#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// The association of one detection.
struct DetectionUse
{
  std::size_t reading = 0, detection = 0;  ///< positions in the frame's scored readings
  std::optional<std::size_t> landmark;     ///< it is associated with; absent: not used
  double inlier_probability = 0;           ///< probability that it shows any landmark and is no clutter
  std::optional<std::size_t> attitude;     ///< in which it is seen to face; absent: not used (facing_update.h)
};

struct KalmanUpdate
{
  KalmanState state;
  double log_evidence = 0;     ///< of everything measured, clutter included
  double nis = 0;              ///< normalised innovation squared, summed over the measurements used
  int degrees_of_freedom = 0;  ///< their number: the expected value of nis
  bool compass_used = false;
  std::vector<DetectionUse> detections;  ///< in the order of the update
};

/// Update of the extended Kalman filter with one frame.
///
/// Detections enter one after the other, each linearised at the state after those before. Each is a mixture, as for
/// particles: p(z) = (1 - e) sum_j s_j N(z; h_j, H_j P H_j^T + R_j) + e / V, with e the clutter probability, V the
/// volume of the measurement space and s_j the share of landmark j among those the detection may show. The product of
/// the p(z) is the evidence: comparable between states that were updated with the same frames, whatever the
/// associations. A detection is used, with full weight, for the landmark that is likelier than everything else together
/// (clutter and other landmarks); otherwise it is left out. Of anonymous detections the most certain ones come first,
/// so that they disambiguate the others (sequential compatibility; two detections may show the same landmark, as in the
/// likelihood of particles). Where the landmark is seen to face a direction, that is one more measurement, left out
/// unless one of its two attitudes is certain (facing_update.h). Landmarks that were not detected count in the evidence
/// where the reading declares a detection probability (missed_detections.h). The covariance is updated in Joseph's form
/// and stays positive definite.
[[nodiscard]] KalmanUpdate updateExtended(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                                          const BiasModel& biases);

/// The same, then moves the state to the maximum of the posterior of the associated detections (Bell and Cathey, "The
/// iterated Kalman filter update as a Gauss-Newton method", IEEE Trans. Autom. Control 38(2), 1993), and linearises the
/// covariance there. A step that does not lower the cost is halved. Evidence and associations are those of
/// updateExtended().
[[nodiscard]] KalmanUpdate updateIterated(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                                          const BiasModel& biases);

/// The frame with as many detections as so many filters can be updated with in some tenths of a second
/// (bounded_frame.h): each is compared with every landmark in view. Nothing for a frame with no more.
[[nodiscard]] std::optional<Frame> affordableToUpdate(const Frame& frame, const LandmarkTable& map,
                                                      std::size_t filters);
}  // namespace mrpt_ext
