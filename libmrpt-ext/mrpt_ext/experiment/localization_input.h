#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/experiment/bearing_extent.h"
#include "mrpt_ext/experiment/detection_reach.h"
#include "mrpt_ext/experiment/method_factory.h"
#include "mrpt_ext/frames/frame_synchronizer.h"
#include "mrpt_ext/observations/usable_detections.h"
#include "mrpt_ext/rawlog/rawlog_source.h"

namespace mrpt_ext
{
/// Part of a log, counted from its first record [s].
struct LogWindow
{
  double start = 0;
  std::optional<double> duration;
};

/// A log of frames: its properties as a whole. The frames are read from the file in every pass, so that hours of them
/// need not fit into memory; that costs little beside the methods.
struct FrameLog
{
  std::filesystem::path path;
  LogWindow window;
  LogOverview overview;
  AvailableMeasurements available;
  DetectionReach reach;
  BearingExtent extent;
  std::size_t frames = 0, detections = 0;
};

/// Everything a run needs, loaded and checked.
struct LocalizationInput
{
  RunContext context;  ///< without version and command line
  LocalizationConfig config;
  FrameLog log;
  std::vector<std::string> notes;  ///< what the log lacks, and what is assumed for it
  std::string warning;             ///< that the log itself states; empty: none
  UnusableCounts unusable;         ///< detections that were left out, by reason
  LogGaps gaps;
  std::vector<std::string> logged_sensors;     ///< labels of the records
  std::vector<std::string> unmatched_sensors;  ///< labels of [Sensor_<label>] without records, perhaps misspelt
};

/// Reads the map and the truth of the settings, and the whole log twice. Throws InputError when a file is missing or
/// damaged, a key is wrong, or nothing in the log can be scored against the map.
[[nodiscard]] LocalizationInput loadLocalization(const Settings& settings, const LogWindow& window);

/// The records of the configured log within the window, as they were logged, laser scans left out. Throws InputError
/// when the file is missing or damaged.
[[nodiscard]] RecordStream loggedRecords(const Settings& settings, const LogWindow& window);

/// Reads the frames of the log from the first one on; `input` must outlive the result. Each pass and thread takes its
/// own.
[[nodiscard]] FrameSynchronizer framesOf(const LocalizationInput& input);
/// The same, without the objects.
[[nodiscard]] FrameStream streamOf(const LocalizationInput& input);
/// The same with other options, which must outlive the result.
[[nodiscard]] FrameStream streamOf(const LocalizationInput& input, const FrameOptions& options);
}  // namespace mrpt_ext
