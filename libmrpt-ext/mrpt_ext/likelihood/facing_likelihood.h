#pragma once

#include <span>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/pose_batch.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
/// The headings that the robot has if the landmark faces as seen, each with its probability and with the standard
/// deviation of sensor and map. Nothing where no direction was measured, where the map has none, or where the landmark
/// is not known: of several landmarks it would tell nothing without their bearings. `bearing_offset` [rad]: systematic
/// error of the sensor's bearings, which turns directions as well.
[[nodiscard]] std::optional<Facing> headingFromFacing(const Detection& detection, const Reading& reading,
                                                      const LandmarkTable& map, double bearing_offset = 0);

/// Density of a heading [1/rad] under them: (1 - e) sum_k w_k N(heading; h_k, std_k) + e / 2 pi, wrapped; e is the
/// clutter probability of the sensor.
[[nodiscard]] double facingDensity(const Facing& headings, double heading, double clutter_probability);

/// Log-likelihood of the directions of the landmarks of a reading, given where the robot heads; always finite, 0
/// without directions. A factor of its own beside the density of bearing and range: an attitude may be wrong where the
/// place is right. `bias`: systematic errors of the sensor.
[[nodiscard]] double facingLogLikelihood(const Reading& reading, const LandmarkTable& map, const Pose2& robot,
                                         const SensorBias& bias = {});

/// Adds the same for many robots, that of robot i to log_likelihood[i].
void addFacingLogLikelihood(const Reading& reading, const LandmarkTable& map, const PoseBatch& robots,
                            std::span<float> log_likelihood);
}  // namespace mrpt_ext
