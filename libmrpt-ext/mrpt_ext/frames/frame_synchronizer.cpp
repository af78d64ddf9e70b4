#include "mrpt_ext/frames/frame_synchronizer.h"

#include <algorithm>
#include <limits>

#include "mrpt_ext/frames/scan_skew.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRounding = 1e-6;  // [s] of stamps with a delay

/// Takes the detections of objects out of a reading; returns them as a reading of their own.
Reading splitObjects(Reading& reading, const std::set<std::string>& categories)
{
  Reading objects = reading;
  const auto isObject = [&](const Detection& d) { return d.id == kNoId && categories.count(d.category) > 0; };
  std::erase_if(reading.detections, isObject);
  std::erase_if(objects.detections, [&](const Detection& d) { return !isObject(d); });
  return objects;
}

/// Expresses both poses of the fix in the frame of the robot at `time`.
void moveTo(RunningFixReading& fix, double time, const OdometryPath& odometry)
{
  const Pose2 T_frame_then = between(odometry.at(time), odometry.at(fix.time));
  fix.T_robot_sensor = compose(T_frame_then, fix.T_robot_sensor);
  fix.displacement = compose(compose(T_frame_then, fix.displacement), inverse(T_frame_then));
  const Matrix3d J = composeJacobianSecond(T_frame_then);
  fix.displacement_covariance = J * fix.displacement_covariance * J.transpose();
}

/// Longest time [s] by which configured delays can reverse the order of two records.
double disorder(const SensorConfigs& sensors)
{
  double least = 0, most = 0;
  for (const auto& [label, config] : sensors)
  {
    least = std::min(least, config.delay);
    most = std::max(most, config.delay);
  }
  return most - least;
}
}  // namespace

FrameSynchronizer::FrameSynchronizer(RecordStream records, const LandmarkTable& map, const FrameOptions& options,
                                     const LogOverview& overview)
    : records_(std::move(records)),
      map_(map),
      options_(options),
      overview_(overview),
      queue_(disorder(options.sensors)),
      ranges_(overview.fix_span)
{
}

FrameSynchronizer::FrameSynchronizer(const LandmarkTable& map, const FrameOptions& options, const LogOverview& overview,
                                     double lateness)
    : map_(map),
      options_(options),
      overview_(overview),
      queue_(disorder(options.sensors) + lateness),
      ranges_(overview.fix_span)
{
}

std::optional<Frame> FrameSynchronizer::next()
{
  while (!readyStamp())
  {
    if (ended_)
    {
      stamp_ = std::numeric_limits<double>::infinity();
      return std::nullopt;
    }
    if (const auto record = records_())
      push(*record);
    else
      close();
  }
  return pop();
}

std::optional<double> FrameSynchronizer::readyStamp() const
{
  // Objects within the window of the frame, and ranges at the times of its fixes, may still arrive.
  const double settled = std::max(options_.window, LoggedRanges::kSameTime);
  if (closed_.empty() || !(now_ - closed_.front().time > settled)) return std::nullopt;
  return closed_.front().time;
}

Frame FrameSynchronizer::pop()
{
  Frame frame = std::move(closed_.front());
  closed_.pop_front();
  complete(frame);
  return frame;
}

double FrameSynchronizer::odometryNeededFrom() const
{
  double longest_sweep = 0;
  for (const auto& [label, config] : options_.sensors) longest_sweep = std::max(longest_sweep, config.sweep.duration);
  return stamp_ ? *stamp_ - longest_sweep : -std::numeric_limits<double>::infinity();
}

std::vector<Frame> FrameSynchronizer::takeObjectFrames()
{
  std::vector<Frame> taken;
  for (; !closed_objects_.empty() && closed_objects_.front().time <= stamp_; closed_objects_.pop_front())
  {
    Frame& frame = closed_objects_.front();
    for (Reading& reading : frame.readings) moveToStamp(reading, frame.time);
    taken.push_back(std::move(frame));
  }
  return taken;
}

void FrameSynchronizer::push(const Record& record)
{
  configure(record);
  if (std::holds_alternative<OdometryRecord>(record)) queue_.passTo(timeOf(record));
  advance();
}

void FrameSynchronizer::close()
{
  queue_.close();
  ended_ = true;
  advance();
}

/// Takes what no record can precede any more.
void FrameSynchronizer::advance()
{
  while (queue_.canPop()) take(queue_.pop().record);
  now_ = std::max(now_, ended_ ? std::numeric_limits<double>::infinity() : queue_.settledTime());
  closeOver(open_, closed_);
  closeOver(open_objects_, closed_objects_);
}

void FrameSynchronizer::configure(const Record& record)
{
  const auto ignored = [&](const std::string& label) { return configOf(options_.sensors, label).ignore; };
  if (const auto* reading = std::get_if<Reading>(&record); reading && !ignored(reading->sensor))
    enqueue(configured(*reading, options_.sensors, map_, unusable_), reading->sensor);
  if (const auto* fix = std::get_if<RunningFixReading>(&record); fix && !ignored(fix->sensor))
    if (auto usable = configured(*fix, options_.sensors, map_, unusable_)) enqueue(std::move(*usable), fix->sensor);
  if (const auto* scan = std::get_if<RangeScan>(&record); scan && !ignored(scan->sensor))
    if (auto usable = configured(*scan, options_.sensors, map_, unusable_)) enqueue(std::move(*usable), scan->sensor);
  if (const auto* compass = std::get_if<CompassRecord>(&record); compass && !ignored(compass->sensor))
    enqueue(configured(*compass, options_.sensors), compass->sensor);
}

void FrameSynchronizer::enqueue(Record record, const std::string& sensor)
{
  if (queue_.isTooLate(timeOf(record) + kRounding))
    ++unusable_[sensor + ": later than records may arrive"];
  else
    queue_.push({.record = std::move(record)});
}

void FrameSynchronizer::take(Record record)
{
  now_ = timeOf(record);
  closeOver(open_, closed_);
  closeOver(open_objects_, closed_objects_);
  if (auto* reading = std::get_if<Reading>(&record)) take(std::move(*reading));
  if (auto* fix = std::get_if<RunningFixReading>(&record))
  {
    ++detections_;
    frameAt(open_, fix->time).fixes.push_back(std::move(*fix));
  }
  if (auto* compass = std::get_if<CompassRecord>(&record))
  {
    // Frames to come are not before it: the newest is enough for them.
    if (!open_ && closed_.empty()) headings_.clear();
    headings_.push_back(std::move(*compass));
  }
}

void FrameSynchronizer::take(Reading landmarks)
{
  Reading objects = splitObjects(landmarks, options_.object_categories);
  if (!objects.detections.empty()) frameAt(open_objects_, objects.time).readings.push_back(std::move(objects));
  // Where missed detections are scored, an empty reading is a measurement too.
  if (landmarks.detections.empty() && !landmarks.model.detection_probability) return;
  detections_ += landmarks.detections.size();
  ranges_.add(landmarks);
  frameAt(open_, landmarks.time).readings.push_back(std::move(landmarks));
}

/// No measurement from now on belongs to a frame whose window is over.
void FrameSynchronizer::closeOver(std::optional<OpenFrame>& open, std::deque<Frame>& closed) const
{
  if (!open || now_ - open->first_time <= options_.window) return;
  closed.push_back(std::move(open->frame));
  open.reset();
}

Frame& FrameSynchronizer::frameAt(std::optional<OpenFrame>& open, double time) const
{
  if (!open) open = OpenFrame{{}, time};
  open->frame.time = time;
  return open->frame;
}

/// Expresses a reading in the frame of the robot at `time`: its detections as if taken at its stamp, the sensor where
/// it was then.
void FrameSynchronizer::moveToStamp(Reading& reading, double time) const
{
  const OdometryPath& odometry = overview_.odometry;
  if (!options_.independent) removeScanSkew(reading, configOf(options_.sensors, reading.sensor).sweep, odometry);
  const Pose2 T_frame_then = between(odometry.at(time), odometry.at(reading.time));
  reading.T_robot_sensor = compose(T_frame_then, reading.T_robot_sensor);
}

/// Adds what depends on the stamp, which is final now, and on the odometry up to it.
void FrameSynchronizer::complete(Frame& frame)
{
  const OdometryPath& odometry = overview_.odometry;
  for (; !headings_.empty() && headings_.front().time <= frame.time; headings_.pop_front())
    frame.compass = std::move(headings_.front());
  if (frame.compass)
  {
    // Several headings since the last frame are hardly independent: only the newest counts.
    const double turned = odometry.between(frame.compass->time, frame.time).increment.phi;
    frame.compass->heading = wrap(frame.compass->heading + turned);
  }
  for (RunningFixReading& fix : frame.fixes) fix.ranges_logged_too = fix.ranges_logged_too || ranges_.holds(fix);
  ranges_.forgetBefore(frame.time);
  if (!options_.independent)
  {
    if (stamp_) frame.motion = odometry.between(*stamp_, frame.time);
    for (Reading& reading : frame.readings) moveToStamp(reading, frame.time);
    for (RunningFixReading& fix : frame.fixes) moveTo(fix, frame.time, odometry);
  }
  stamp_ = frame.time;
}
}  // namespace mrpt_ext
