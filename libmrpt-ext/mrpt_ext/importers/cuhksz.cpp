#include "mrpt_ext/importers/cuhksz.h"

#include <cmath>

#include "mrpt_ext/importers/date_time.h"
#include "mrpt_ext/importers/range_field.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/run_files.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;

const RunFileName kRanges{"UWB_", ".csv"}, kTruth{"motion_capture_", ".csv"};

/// Date and time of a row as seconds, which must not be before `before`.
double timeOfRow(const TextTable& table, std::size_t row, double before)
{
  const auto time = parseDateTime(table.text(row, 0));
  if (!time)
    throw table.errorAt(row, "'" + table.text(row, 0) + "' is no date and time, expected e.g. 2022-08-15 9:42:24.766");
  if (*time < before)
    throw table.errorAt(row, "time " + table.text(row, 0) + " is before the row above, expected ascending times");
  return *time;
}

LandmarkTable anchors()
{
  std::vector<Landmark> landmarks;
  for (std::size_t i = 0; i < kCuhkszAnchors.size(); ++i)
    landmarks.push_back({static_cast<int>(i), kCuhkszAnchors[i], kCuhkszCategory, {0, 0}});
  return LandmarkTable(std::move(landmarks));
}

std::size_t columnOf(std::size_t anchor, std::size_t tag) { return 1 + anchor * kCuhkszTags.size() + tag; }

std::vector<std::string> rangeColumns()
{
  std::vector<std::string> columns{"time"};
  for (std::size_t anchor = 0; anchor < kCuhkszAnchors.size(); ++anchor)
    for (std::size_t tag = 0; tag < kCuhkszTags.size(); ++tag)
      columns.push_back('a' + std::to_string(anchor) + "-t" + std::to_string(tag));
  return columns;
}

Reading readTag(const TextTable& table, std::size_t row, std::size_t tag, double time)
{
  Reading reading;
  reading.time = time;
  reading.sensor = "tag" + std::to_string(tag);
  reading.T_robot_sensor = {kCuhkszTags[tag].x(), kCuhkszTags[tag].y(), 0};
  reading.sensor_height = kCuhkszBodyHeight + kCuhkszTags[tag].z();
  for (std::size_t anchor = 0; anchor < kCuhkszAnchors.size(); ++anchor)
    if (const auto range = radioRange(table, row, columnOf(anchor, tag), kCuhkszMostRange))
      reading.detections.push_back(
          {static_cast<int>(anchor), kCuhkszCategory, std::nullopt, *range, 0, kCuhkszStdRange});
  return reading;
}

void addRanges(Recording& recording, const fs::path& path)
{
  const TextTable table(path, {Delimiter::comma, "#", rangeColumns()});
  std::size_t missing = 0, empty = 0;
  double time = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    time = timeOfRow(table, row, time);
    for (std::size_t tag = 0; tag < kCuhkszTags.size(); ++tag)
    {
      Reading reading = readTag(table, row, tag, time);
      missing += kCuhkszAnchors.size() - reading.detections.size();
      empty += reading.detections.empty();
      if (!reading.detections.empty()) recording.records.emplace_back(std::move(reading));
    }
  }
  noteCount(recording, table.size(), "rows of ranges");
  noteCount(recording, missing, "ranges are empty or 0: not measured");
  noteCount(recording, empty, "readings of a tag without any range dropped");
  recording.notes.emplace_back("no odometry in this set");
}

/// Pose in the plane of a row of the motion capture: heading of the body's x axis.
TimedPose readBody(const TextTable& table, std::size_t row, double time)
{
  const double w = table.number(row, 4), x = table.number(row, 5), y = table.number(row, 6), z = table.number(row, 7);
  const double norm = w * w + x * x + y * y + z * z;
  if (std::abs(norm - 1) > 0.01)
    throw table.errorAt(row, "quaternion of squared length " + fixedText(norm, 3) + ", expected 1 (qw,qx,qy,qz)");
  const double heading = std::atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
  return {time, {table.number(row, 1), table.number(row, 2), wrap(heading)}, true};
}

void addTruth(Recording& recording, const fs::path& path)
{
  if (!fs::exists(path))
  {
    recording.notes.emplace_back("no truth file");
    return;
  }
  // The header line names four of eight columns.
  const TextTable table(path, {Delimiter::comma, "time,", {"time", "x", "y", "z", "qw", "qx", "qy", "qz"}});
  std::size_t repeated = 0;
  double time = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double before = time;
    time = timeOfRow(table, row, before);
    const TimedPose pose = readBody(table, row, time);
    if (time == before)
      ++repeated;
    else
      recording.truth.push_back(pose);
  }
  noteCount(recording, repeated, "poses of the truth share the stamp of the row before and were dropped");
}
}  // namespace

Recording importCuhksz(const fs::path& input)
{
  const RunFiles run = chooseRun(input, kRanges);
  Recording recording;
  recording.map = anchors();
  addRanges(recording, run.file(kRanges));
  addTruth(recording, run.file(kTruth));
  return recording;
}
}  // namespace mrpt_ext
