#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/filter/integrity/landmark_reliability.h"
#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// Estimate of a systematic error, in the unit of its kind.
struct BiasEstimate
{
  double mean = 0, std = 0;
};

/// Mean and standard deviation of every systematic error over normalised particles, in the order of their bias states.
[[nodiscard]] std::vector<BiasEstimate> estimateBiases(const ParticleSet& particles);

/// "stereo.range_scale", "bearing_offset_deg": the sensor, if the error belongs to one, the kind, and the unit in
/// files.
[[nodiscard]] std::string biasName(const BiasState& bias);
/// A value of this error in files is this times BiasState::mean.
[[nodiscard]] double fileUnit(const BiasState& bias);

/// "range_offset 0.1200 m (std 0.0100), uwb bearing_offset ... deg (std ...)"; empty without any.
[[nodiscard]] std::string biasText(const BiasModel& biases, const std::vector<BiasEstimate>& estimates);

/// Positions in the table of the landmarks of whose identified detections significantly more than 30 % are outliers.
[[nodiscard]] std::vector<std::size_t> outlierLandmarks(const std::vector<LandmarkHistory>& histories);

/// "landmark 7: 93 % of 210 detections are outliers, landmark 9: ..."; at most five are named, the
/// others counted; empty without any.
[[nodiscard]] std::string outlierText(const LandmarkTable& map, const std::vector<LandmarkHistory>& histories);
}  // namespace mrpt_ext
