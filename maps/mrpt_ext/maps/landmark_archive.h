#pragma once

#include <mrpt/serialization/serialization_frwds.h>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/maps/landmark_likelihood_options.h"

/// Serialization of the parts of CLandmarkMap2D.
namespace mrpt_ext
{
/// True when some landmark faces a known direction.
[[nodiscard]] bool hasDirections(const LandmarkTable& landmarks);

/// With the directions in which landmarks face, or without.
void writeLandmarks(mrpt::serialization::CArchive& out, const LandmarkTable& landmarks, bool with_directions);
[[nodiscard]] LandmarkTable readLandmarks(mrpt::serialization::CArchive& in, bool with_directions);

void writeOptions(mrpt::serialization::CArchive& out, const LandmarkLikelihoodOptions& options);
void readOptions(mrpt::serialization::CArchive& in, LandmarkLikelihoodOptions& options);
}  // namespace mrpt_ext
