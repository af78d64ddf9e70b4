#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/pipeline/frame_builder.h"
#include "mrpt_ext/pipeline/localization_config.h"
#include "mrpt_ext/pipeline/rawlog_source.h"

namespace mrpt_ext
{
/// Part of a log, counted from its first record [s].
struct LogWindow
{
  double start = 0;
  std::optional<double> duration;
};

/// Everything a run needs, loaded and checked.
struct LocalizationInput
{
  RunContext context;  ///< without version and command line
  LocalizationConfig config;
  FrameSequence sequence;
  UnusableCounts unusable;                     ///< detections that were left out, by reason
  std::vector<std::string> logged_sensors;     ///< labels of the records
  std::vector<std::string> unmatched_sensors;  ///< labels of [Sensor_<label>] that no record has, perhaps misspelt
};

/// Reads map, log and truth that the settings name, and cuts the log into frames. Throws InputError when a file is
/// missing or damaged, a key is wrong, or nothing in the log can be scored against the map.
[[nodiscard]] LocalizationInput loadLocalization(const Settings& settings, const LogWindow& window);
}  // namespace mrpt_ext
