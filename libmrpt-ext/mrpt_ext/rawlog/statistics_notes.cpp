#include "mrpt_ext/rawlog/statistics_notes.h"

#include "mrpt_ext/importers/recording_notes.h"

namespace mrpt_ext
{
void addStatistics(Recording& recording, const RawlogStatistics& statistics)
{
  for (const auto& [name, count] : statistics.observations)
    recording.notes.push_back(name + ": " + std::to_string(count.total) + " in the log, " + std::to_string(count.used) +
                              " used, " + std::to_string(count.ignored) + " ignored");
  for (const auto& [reason, count] : statistics.unusable) noteCount(recording, count, "unusable, " + reason);
}
}  // namespace mrpt_ext
