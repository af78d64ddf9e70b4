#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/landmark_reliability.h"
#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// What is known by now about a systematic error, in the unit of its kind.
struct BiasEstimate
{
  double mean = 0, std = 0;
};

/// Mean and deviation of every systematic error over normalised particles, in the order of their bias states.
[[nodiscard]] std::vector<BiasEstimate> estimateBiases(const ParticleSet& particles);

/// "stereo.range_scale", "bearing_offset_deg": its sensor, if it has one, its kind, and the unit that files have it in.
[[nodiscard]] std::string biasName(const BiasState& bias);
/// Files have angles in degrees: what a value of this error is multiplied by.
[[nodiscard]] double fileUnit(const BiasState& bias);

/// The errors that are estimated, in words: "range_offset 0.120 m (std 0.010)", angles in degrees; empty without any.
[[nodiscard]] std::string biasText(const BiasModel& biases, const std::vector<BiasEstimate>& estimates);

/// Positions in the table of the landmarks of whose named detections more than three in ten are false, and more than
/// chance makes of three in ten.
[[nodiscard]] std::vector<std::size_t> outlierLandmarks(const std::vector<LandmarkHistory>& histories);

/// They in words: "landmark 7 is often wrong (93 % of its 210 detections)"; empty without any.
[[nodiscard]] std::string outlierText(const LandmarkTable& map, const std::vector<LandmarkHistory>& histories);
}  // namespace mrpt_ext
