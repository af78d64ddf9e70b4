#pragma once

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// Compares the clocks of a loaded log: odometry with detections, and the truth with the log. Throws InputError (data)
/// when two of them have no time in common; adds a line to the notes of `input` when odometry misses a part of the
/// detections, and one when it jumps.
void checkClocks(LocalizationInput& input);
}  // namespace mrpt_ext
