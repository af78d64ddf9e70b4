#pragma once

#include <mrpt/obs/CObservation.h>

#include <vector>

#include "mrpt_ext/observations/CObservationLandmarkBearings.h"
#include "mrpt_ext/observations/CObservationRunningFix.h"
#include "mrpt_ext/observations/CObservationStereoRanges.h"

namespace mrpt_ext
{
/// One of each class of ours with no field left at its default.
[[nodiscard]] CObservationLandmarkBearings::Ptr sampleBearings();
[[nodiscard]] CObservationStereoRanges::Ptr sampleRanges();
/// The same, of which two landmarks show which way they face: one in one attitude, one in one of two.
[[nodiscard]] CObservationStereoRanges::Ptr sampleFacings();
[[nodiscard]] CObservationRunningFix::Ptr sampleFix();

[[nodiscard]] std::vector<mrpt::obs::CObservation::Ptr> samplesOfAllClasses();
}  // namespace mrpt_ext
