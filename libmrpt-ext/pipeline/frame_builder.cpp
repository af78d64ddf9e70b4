#include "mrpt_ext/pipeline/frame_builder.h"

#include <algorithm>
#include <map>

namespace mrpt_ext
{
namespace
{
template <typename T>
void sortByTime(std::vector<T>& entries)
{
  std::stable_sort(entries.begin(), entries.end(), [](const T& a, const T& b) { return a.time < b.time; });
}

/// Takes the detections of objects out of a reading; returns them as a reading of their own.
Reading splitObjects(Reading& reading, const std::set<std::string>& categories)
{
  Reading objects = reading;
  const auto isObject = [&](const Detection& d) { return d.id == kNoId && categories.count(d.category) > 0; };
  std::erase_if(reading.detections, isObject);
  std::erase_if(objects.detections, [&](const Detection& d) { return !isObject(d); });
  return objects;
}

/// Everything with a time of its own, sorted, configuration applied.
struct SortedMeasurements
{
  std::vector<Reading> readings, objects;
  std::vector<RunningFixReading> fixes;
  std::vector<CompassRecord> headings;
  std::vector<OdometryRecord> odometry;
};

SortedMeasurements sortMeasurements(const std::vector<Record>& records, const LandmarkTable& map,
                                    const FrameOptions& options, UnusableDetections& unusable)
{
  SortedMeasurements sorted;
  const auto ignored = [&](const std::string& label) { return configOf(options.sensors, label).ignore; };
  for (const Record& record : records)
  {
    if (const auto* odometry = std::get_if<OdometryRecord>(&record)) sorted.odometry.push_back(*odometry);
    if (const auto* reading = std::get_if<Reading>(&record); reading && !ignored(reading->sensor))
    {
      Reading landmarks = configured(*reading, options.sensors, map, unusable);
      Reading objects = splitObjects(landmarks, options.object_categories);
      if (!objects.detections.empty()) sorted.objects.push_back(std::move(objects));
      // An empty reading still tells that nothing was seen, where missed detections are scored.
      if (!landmarks.detections.empty() || landmarks.model.detection_probability)
        sorted.readings.push_back(std::move(landmarks));
    }
    if (const auto* fix = std::get_if<RunningFixReading>(&record); fix && !ignored(fix->sensor))
      if (auto usable = configured(*fix, options.sensors, map, unusable)) sorted.fixes.push_back(std::move(*usable));
    if (const auto* compass = std::get_if<CompassRecord>(&record); compass && !ignored(compass->sensor))
      sorted.headings.push_back(configured(*compass, options.sensors));
  }
  sortByTime(sorted.readings);
  sortByTime(sorted.objects);
  sortByTime(sorted.fixes);
  sortByTime(sorted.headings);
  return sorted;
}

/// A fix whose single ranges are logged as well must not be counted twice. They are ranges to its landmark at one of
/// its own times, under its own label or, where an app writes fixes under another one, with its own value.
void markDoubleEvidence(SortedMeasurements& sorted)
{
  constexpr double kSameTime = 1e-3, kSameRange = 1e-3;  // s, m
  struct LoggedRange
  {
    std::string sensor;
    double range;
  };
  std::map<int, std::multimap<double, LoggedRange>> ranges;  // by landmark and time
  for (const Reading& reading : sorted.readings)
    for (const Detection& d : reading.detections)
      if (d.range) ranges[d.id].emplace(reading.time, LoggedRange{reading.sensor, *d.range});
  const auto logged = [&](const RunningFixReading& fix, double time, double range)
  {
    const auto& of_landmark = ranges[fix.id];
    return std::any_of(of_landmark.lower_bound(time - kSameTime), of_landmark.upper_bound(time + kSameTime),
                       [&](const auto& entry) {
                         return entry.second.sensor == fix.sensor || std::abs(entry.second.range - range) < kSameRange;
                       });
  };
  for (RunningFixReading& fix : sorted.fixes)
    fix.ranges_logged_too = fix.ranges_logged_too || logged(fix, fix.first_time, fix.first_range) ||
                            logged(fix, fix.time, fix.second_range);
}

/// Stamps of the frames: each is the last measurement within the window of the frame's first one.
std::vector<double> frameStamps(const SortedMeasurements& sorted, double window)
{
  std::vector<double> times;
  for (const Reading& reading : sorted.readings) times.push_back(reading.time);
  for (const RunningFixReading& fix : sorted.fixes) times.push_back(fix.time);
  std::sort(times.begin(), times.end());
  std::vector<double> stamps;
  double first = 0;
  for (const double time : times)
  {
    if (!stamps.empty() && time - first <= window)
      stamps.back() = time;
    else
    {
      first = time;
      stamps.push_back(time);
    }
  }
  return stamps;
}

void carryTo(Reading& reading, double time, const OdometryPath& odometry)
{
  const Pose2 T_frame_then = between(odometry.at(time), odometry.at(reading.time));
  reading.T_robot_sensor = compose(T_frame_then, reading.T_robot_sensor);
}

/// Both places of the fix as seen from where the robot is at `time`.
void carryTo(RunningFixReading& fix, double time, const OdometryPath& odometry)
{
  const Pose2 T_frame_then = between(odometry.at(time), odometry.at(fix.time));
  fix.T_robot_sensor = compose(T_frame_then, fix.T_robot_sensor);
  fix.displacement = compose(compose(T_frame_then, fix.displacement), inverse(T_frame_then));
  const Matrix3d J = composeJacobianSecond(T_frame_then);
  fix.displacement_covariance = J * fix.displacement_covariance * J.transpose();
}

/// Moves entries with time <= stamp from `sorted` (from `next` on) into `taken`.
template <typename T>
void takeUntil(const std::vector<T>& sorted, std::size_t& next, double stamp, std::vector<T>& taken)
{
  while (next < sorted.size() && sorted[next].time <= stamp) taken.push_back(sorted[next++]);
}

std::vector<Frame> cutFrames(const SortedMeasurements& sorted, const std::vector<double>& stamps,
                             const OdometryPath& odometry, bool independent)
{
  std::vector<Frame> frames;
  std::size_t reading = 0, fix = 0, heading = 0;
  for (const double stamp : stamps)
  {
    Frame frame;
    frame.time = stamp;
    takeUntil(sorted.readings, reading, stamp, frame.readings);
    takeUntil(sorted.fixes, fix, stamp, frame.fixes);
    std::vector<CompassRecord> headings;
    takeUntil(sorted.headings, heading, stamp, headings);
    if (!headings.empty())
    {
      // Several headings since the last frame are hardly independent: the newest speaks for all.
      frame.compass = headings.back();
      const double turned = odometry.between(frame.compass->time, stamp).increment.phi;
      frame.compass->heading = wrap(frame.compass->heading + turned);
    }
    if (!independent && !frames.empty()) frame.motion = odometry.between(frames.back().time, stamp);
    if (!independent)
    {
      for (Reading& r : frame.readings) carryTo(r, stamp, odometry);
      for (RunningFixReading& f : frame.fixes) carryTo(f, stamp, odometry);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

std::vector<Frame> cutObjectFrames(const SortedMeasurements& sorted, double window, const OdometryPath& odometry)
{
  SortedMeasurements objects;
  objects.readings = sorted.objects;
  return cutFrames(objects, frameStamps(objects, window), odometry, false);
}
}  // namespace

FrameSequence buildFrames(const std::vector<Record>& records, const LandmarkTable& map, const FrameOptions& options)
{
  FrameSequence sequence;
  SortedMeasurements sorted = sortMeasurements(records, map, options, sequence.unusable);
  markDoubleEvidence(sorted);
  sequence.odometry = OdometryPath(sorted.odometry, options.odometry);
  sequence.frames = cutFrames(sorted, frameStamps(sorted, options.window), sequence.odometry, options.independent);
  sequence.object_frames = cutObjectFrames(sorted, options.window, sequence.odometry);
  for (const Reading& reading : sorted.readings) sequence.detections += reading.detections.size();
  sequence.detections += sorted.fixes.size();
  return sequence;
}
}  // namespace mrpt_ext
