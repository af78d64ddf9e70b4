#pragma once

#include <mrpt/serialization/serialization_frwds.h>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/maps/landmark_likelihood_options.h"

/// Serialization of the parts of CLandmarkMap2D.
namespace mrpt_ext
{
void writeLandmarks(mrpt::serialization::CArchive& out, const LandmarkTable& landmarks);
[[nodiscard]] LandmarkTable readLandmarks(mrpt::serialization::CArchive& in);

void writeOptions(mrpt::serialization::CArchive& out, const LandmarkLikelihoodOptions& options);
void readOptions(mrpt::serialization::CArchive& in, LandmarkLikelihoodOptions& options);
}  // namespace mrpt_ext
