#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/landmark_clutter.h"
#include "mrpt_ext/likelihood/pose_batch.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
/// Log-likelihood of a reading for one robot pose, normalised over the measurement space and always finite.
///
/// Per detection p(z) = (1 - e) sum_j s_j N(z; h_j, R_j) + e / V, with e the clutter probability, V the volume of the
/// measurement space, and j over the landmarks the detection may show (by id: one; by category or anonymous: several,
/// each weighted by its share s_j of the expected detections). An id that is not in the map can only be clutter.
/// Where field of view, range limit and detection probability are all declared, the landmarks in view that were not
/// reported count as well (see missed_detections.h).
/// Where detections tell which way their landmarks face, that is a further factor (facing_likelihood.h).
/// Double precision; `bias`: systematic errors of the sensor.
[[nodiscard]] double logLikelihood(const Reading& reading, const LandmarkTable& map, const Pose2& robot,
                                   const LandmarkClutter& clutter = {}, const SensorBias& bias = {});

/// The same for many robot poses in one call, in single precision (see ReadingScorer, which leaves directions out):
/// adds the log-likelihood of pose i to log_likelihood[i].
void addLogLikelihood(const Reading& reading, const LandmarkTable& map, const LandmarkClutter& clutter,
                      const PoseBatch& robots, std::span<float> log_likelihood);

/// For one pose: the posterior probability that each detection shows each landmark.
/// Entry [d][j] belongs to detection d and landmark j of the table; what is missing to 1 in a row is clutter.
[[nodiscard]] std::vector<std::vector<double>> associationProbabilities(const Reading& reading,
                                                                        const LandmarkTable& map,
                                                                        const LandmarkClutter& clutter,
                                                                        const Pose2& robot,
                                                                        const SensorBias& bias = {});
}  // namespace mrpt_ext
