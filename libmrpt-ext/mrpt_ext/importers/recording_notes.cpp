#include "mrpt_ext/importers/recording_notes.h"

#include <algorithm>
#include <map>
#include <set>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/formatted.h"
#include "mrpt_ext/importers/odometry_lag.h"

namespace mrpt_ext
{
namespace
{
/// Stamps of one type of record.
struct Series
{
  std::size_t count = 0;
  double first = 0, last = 0, longest_gap = 0;

  void add(double time)
  {
    if (count++ == 0) first = last = time;
    longest_gap = std::max(longest_gap, time - last);
    last = time;
  }
  [[nodiscard]] std::string text() const
  {
    const double duration = last - first;
    if (!(duration > 0)) return "";
    return ", " + fixedText(duration, 1) + " s, " + fixedText((static_cast<double>(count) - 1) / duration, 2) +
           " per s, longest gap " + fixedText(longest_gap, 2) + " s";
  }
};

struct SensorSeries
{
  Series stamps;
  std::vector<double> times;
  std::size_t detections = 0, bearings = 0, ranges = 0, unknown_ids = 0, unknown_categories = 0, duplicates = 0;

  void add(const Reading& reading, const LandmarkTable& map, const std::set<std::string>& categories)
  {
    stamps.add(reading.time);
    times.push_back(reading.time);
    detections += reading.detections.size();
    std::set<int> identified;
    for (const Detection& detection : reading.detections)
    {
      bearings += detection.bearing.has_value();
      ranges += detection.range.has_value();
      unknown_ids += detection.id != kNoId && !map.indexOf(detection.id);
      unknown_categories +=
          detection.id == kNoId && !detection.category.empty() && !categories.contains(detection.category);
      duplicates += detection.id != kNoId && !identified.insert(detection.id).second;
    }
  }
  [[nodiscard]] std::string text(const std::string& name) const
  {
    return "sensor " + name + ": " + std::to_string(stamps.count) + " readings with " + std::to_string(detections) +
           " detections (" + std::to_string(bearings) + " bearings, " + std::to_string(ranges) + " ranges)" +
           stamps.text();
  }
};

std::string describeTruth(const Trajectory& truth)
{
  Series stamps;
  std::size_t without_heading = 0;
  for (const TimedPose& entry : truth)
  {
    stamps.add(entry.time);
    without_heading += !entry.heading_known;
  }
  std::string text = "truth: " + std::to_string(stamps.count) + " poses" + stamps.text();
  if (without_heading > 0) text += ", " + std::to_string(without_heading) + " without a heading";
  return text;
}
}  // namespace

void sortByTime(Recording& recording)
{
  std::stable_sort(recording.records.begin(), recording.records.end(),
                   [](const Record& a, const Record& b) { return timeOf(a) < timeOf(b); });
}

void noteCount(Recording& recording, std::size_t count, const std::string& what)
{
  if (count > 0) recording.notes.push_back(std::to_string(count) + ' ' + what);
}

std::vector<std::string> describe(const Recording& recording)
{
  std::set<std::string> categories;
  for (const Landmark& landmark : recording.map.all()) categories.insert(landmark.category);
  Series odometry;
  std::vector<double> odometry_times;
  std::map<std::string, SensorSeries> sensors;
  std::map<std::string, Series> others;
  for (const Record& record : recording.records)
  {
    if (std::get_if<OdometryRecord>(&record))
    {
      odometry.add(timeOf(record));
      odometry_times.push_back(timeOf(record));
    }
    if (const auto* reading = std::get_if<Reading>(&record))
      sensors[reading->sensor].add(*reading, recording.map, categories);
    if (const auto* fix = std::get_if<RunningFixReading>(&record))
      others["running fixes " + fix->sensor].add(fix->time);
    if (const auto* scan = std::get_if<RangeScan>(&record)) others["laser scans " + scan->sensor].add(scan->time);
    if (const auto* compass = std::get_if<CompassRecord>(&record))
      others["compass " + compass->sensor].add(compass->time);
  }
  std::vector<std::string> lines;
  lines.push_back("odometry: " + std::to_string(odometry.count) + " records" + odometry.text());
  for (const auto& [name, series] : sensors)
  {
    const std::string label = "sensor " + name + ": ";
    lines.push_back(series.text(name));
    if (const auto lag = odometryLag(odometry_times, series.times)) lines.push_back(label + describe(*lag));
    if (series.duplicates > 0)
      lines.push_back(label + std::to_string(series.duplicates) + " detections repeat an id of the same reading");
    if (series.unknown_ids > 0)
      lines.push_back(label + std::to_string(series.unknown_ids) + " detections have an id that is not in the map");
    if (series.unknown_categories > 0)
      lines.push_back(label + std::to_string(series.unknown_categories) +
                      " detections have a category that no landmark has");
  }
  for (const auto& [name, series] : others) lines.push_back(name + ": " + std::to_string(series.count) + series.text());
  lines.push_back(describeTruth(recording.truth));
  lines.push_back("map: " + countOf(recording.map.size(), "landmark"));
  return lines;
}
}  // namespace mrpt_ext
