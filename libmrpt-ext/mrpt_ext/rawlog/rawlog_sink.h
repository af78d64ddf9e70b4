#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "mrpt_ext/geometry/record_stream.h"

namespace mrpt_ext
{
/// Writes a recording as an observation-only rawlog, gzip-compressed, under a temporary name that is renamed at the
/// end.
///
/// Odometry becomes CObservationOdometry "odometry", running fixes CObservationRunningFix, headings CObservationIMU
/// (which has no field for the standard deviation). All readings of a sensor label become the same class, so that
/// rawlog-edit --export-txt gives one table per label: CObservationStereoRanges if any has a range, else
/// CObservationLandmarkBearings. The first entry is a comment "entries=N" that RawlogReader compares, with a second
/// line "warning=..." when there is something that users of the log are to be told.
///
/// The same recording gives the same bytes. Throws InputError (data) for a record with a time that is not finite,
/// a sensor without label or records out of order, and when the file cannot be written completely.
void writeRawlog(const std::filesystem::path& path, const Recording& recording, const std::string& warning = {});

/// The same for records that need not fit into memory: `records` starts over with every call, and is called twice,
/// since the first entry holds their number. Returns that number.
std::size_t writeRawlog(const std::filesystem::path& path, const std::function<RecordStream()>& records,
                        const std::string& warning = {});
}  // namespace mrpt_ext
