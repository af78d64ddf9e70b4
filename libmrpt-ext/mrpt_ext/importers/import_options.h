#pragma once

#include "mrpt_ext/geometry/identity_level.h"
#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Which quantities are kept.
enum class MeasurementSelection
{
  range_bearing,
  bearing,
  range
};

/// Removes ids, or ids and categories, from all detections; the map keeps them. Throws InputError (configuration) when
/// categories are asked for and no detection has one.
void hideIdentity(Recording& recording, IdentityLevel identity);

/// Removes bearings or ranges. A detection left with neither is dropped, so is a reading left without detections; both
/// are counted in the notes. Throws InputError (configuration) when nothing would be left.
void keepMeasurements(Recording& recording, MeasurementSelection measurements);
}  // namespace mrpt_ext
