#pragma once

#include <optional>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// The direction in which a landmark faces, as a state predicts it.
struct FacingInnovation
{
  double evidence = 0;                  ///< p(direction) under the state, clutter included [1/rad]
  std::optional<std::size_t> attitude;  ///< the one that is certain and no clutter; absent: leave it out
  double nis = 0;                       ///< normalised innovation squared to it
};

/// The mixture of facing_likelihood.h, each Gaussian widened by the state's heading. An attitude is certain where given
/// the state it has at least kCertainAttitude of the probability of both, and is likelier than clutter. Nothing where
/// headingFromFacing() gives none.
[[nodiscard]] std::optional<FacingInnovation> compareFacing(const Detection& detection, const Reading& reading,
                                                            const LandmarkTable& map, const KalmanState& state,
                                                            const BiasModel& biases);

/// The row of an attitude of a detection for which compareFacing() gives one, linearised at `mean`.
[[nodiscard]] KalmanRow lineariseFacing(const Detection& detection, std::size_t attitude, const Reading& reading,
                                        const LandmarkTable& map, const KalmanVector& mean, const BiasModel& biases);
}  // namespace mrpt_ext
