#pragma once

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/rawlog/rawlog_source.h"

namespace mrpt_ext
{
/// Adds what the log contains, and what of it is used, to the notes of a recording made from it.
void addStatistics(Recording& recording, const RawlogStatistics& statistics);
}  // namespace mrpt_ext
