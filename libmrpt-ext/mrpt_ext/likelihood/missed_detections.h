#pragma once

#include <span>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext
{
/// True when the reading declares what a test of missed detections needs: detection probability, range and field of
/// view.
[[nodiscard]] bool scoresMissedDetections(const Reading& reading);

/// Log-probability of which landmarks were reported and which were not.
///
/// Identified detections, or none at all: product over the map of P_D c_j for a reported and 1 - P_D c_j for an
/// unreported landmark, c_j being its visibility. Anonymous ones: the number of detections is
/// compared with its expectation sum_j P_D c_j plus clutter (Gaussian approximation of the Poisson-binomial count).
/// Both are mixed with a small uniform share, so that one wrong visibility can never outweigh the measurements
/// themselves. `predictions` holds one entry per landmark of the map.
[[nodiscard]] double logMissedDetections(const Reading& reading, const LandmarkTable& map,
                                         std::span<const LandmarkPrediction> predictions);

/// True when every detection has an id (also for no detection at all).
[[nodiscard]] bool areIdentified(const Reading& reading);

/// Probability of the report or of the miss of a landmark that is detected with `probability`.
[[nodiscard]] double reportProbability(double probability, bool reported);

/// The part of the likelihood of the number of anonymous detections that all poses share.
struct CountModel
{
  double count = 0;             ///< detections
  double expected_clutter = 0;  ///< of them
  double extra_variance = 0;    ///< beside that of the landmarks: clutter and rounding
  double gaussian_share = 1;    ///< of the mixture
  double uniform = 0;           ///< the mixture's other part
};
[[nodiscard]] CountModel countModel(const Reading& reading, std::size_t landmarks);
}  // namespace mrpt_ext
