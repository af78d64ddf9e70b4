#pragma once

#include <span>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext
{
/// True when the reading declares all that is needed to hold unseen landmarks against a pose.
[[nodiscard]] bool scoresMissedDetections(const Reading& reading);

/// Log-probability of which landmarks were reported and which were not.
///
/// Identified detections, or none at all: product over the map of P_D c_j for a reported and 1 - P_D c_j for an
/// unreported landmark, c_j being the chance that it is in view. Unidentified ones: the number of detections is
/// compared with its expectation sum_j P_D c_j plus clutter (Gaussian approximation of the Poisson-binomial count).
/// Both are mixed with a small uniform share, so that one wrong visibility can never outweigh the measurements
/// themselves. `predictions` holds one entry per landmark of the map.
[[nodiscard]] double logMissedDetections(const Reading& reading, const LandmarkTable& map,
                                         std::span<const LandmarkPrediction> predictions);
}  // namespace mrpt_ext
