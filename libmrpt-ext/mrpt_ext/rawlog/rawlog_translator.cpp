#include "mrpt_ext/rawlog/rawlog_translator.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include "mrpt_ext/observations/logged_flag.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/rawlog/action_frames.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kActions = "actions";
constexpr const char* kNoTime = "no time stamp";

constexpr double kLeastStep = 1e-6;  ///< [s] between two sensory frames
constexpr const char* kOutsideFrames = "outside the sensory frames, whose count is the clock";

Pose2 planar(const mrpt::poses::CPose2D& pose) { return {pose.x(), pose.y(), pose.phi()}; }
}  // namespace

std::set<std::string> translatedClasses(const ScanFilter& scans)
{
  std::set<std::string> classes = {"CObservationOdometry",         "CObservationIMU",
                                   "CObservationLandmarkBearings", "CObservationStereoRanges",
                                   "CObservationBearingRange",     "CObservationBeaconRanges",
                                   "CObservationRunningFix"};
  if (scans) classes.insert("CObservation2DRangeScan");
  return classes;
}

std::optional<std::vector<RawlogTranslator::Output>> RawlogTranslator::translate(
    const mrpt::serialization::CSerializable& entry)
{
  output_.clear();
  step_.reset();
  if (const auto* actions = dynamic_cast<const mrpt::obs::CActionCollection*>(&entry))
    for (const auto& action : *actions) readAction(*action);
  else if (const auto* action = dynamic_cast<const mrpt::obs::CAction*>(&entry))
    readAction(*action);
  else if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(&entry))
    readFrame(*frame);
  else if (const auto* observation = dynamic_cast<const mrpt::obs::CObservation*>(&entry))
    readObservation(*observation, std::nullopt);
  else
    return std::nullopt;
  return std::move(output_);
}

void RawlogTranslator::readAction(const mrpt::obs::CAction& action)
{
  const std::string name = shortClassName(action);
  const auto moved = incrementOf(action);
  if (!moved) return count(name, "not a robot movement");
  const Pose2 increment = planar(mrpt::poses::CPose2D(*moved));
  if (odometry_source_.empty())
  {
    odometry_source_ = kActions;
    if (first_frame_time_) emit(OdometryRecord{*first_frame_time_, dead_reckoned_});
  }
  if (odometry_source_ != kActions) return count(name, "a second source of odometry");
  if (!isFinite(increment)) return count(name, "not finite");
  dead_reckoned_ = compose(dead_reckoned_, increment);
  pending_actions_.push_back({name, timeOf(action.timestamp)});
}

void RawlogTranslator::readFrame(const mrpt::obs::CSensoryFrame& frame)
{
  auto time = latestTime(frame);
  if (!time && !pending_actions_.empty()) time = pending_actions_.back().time;
  if (clock_.step)
    time = *clock_.step * static_cast<double>(frames_);
  else if (time && !frame_times_.empty() && *time <= frame_times_.back())
    time = frame_times_.back() + kLeastStep;
  ++frames_;
  if (!pending_actions_.empty())
  {
    step_ = step_times_.size();
    step_times_.push_back(time.value_or(step_times_.empty() ? 0 : step_times_.back()));
    for (const PendingAction& action : pending_actions_) count(action.class_name, time ? "" : kNoTime);
    pending_actions_.clear();
  }
  if (odometry_source_.empty()) first_frame_time_ = time;
  if (time && odometry_source_ == kActions) emit(OdometryRecord{*time, dead_reckoned_});
  for (const auto& observation : frame) readObservation(*observation, time);
  if (time) frame_times_.push_back(*time);
}

void RawlogTranslator::readObservation(const mrpt::obs::CObservation& observation, std::optional<double> frame_time)
{
  if (clock_.step && !frame_time) return count(shortClassName(observation), kOutsideFrames);
  const auto own_time = timeOf(observation.timestamp);
  // Odometry may be logged several times within a frame.
  const bool is_odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation) != nullptr;
  const auto time = frame_time && !(is_odometry && own_time && !clock_.step) ? frame_time : own_time;
  count(shortClassName(observation), time ? useObservation(observation, *time) : kNoTime);
}

std::string RawlogTranslator::useObservation(const mrpt::obs::CObservation& observation, double time)
{
  if (dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation)) return useOdometry(observation, time);
  if (dynamic_cast<const mrpt::obs::CObservationIMU*>(&observation)) return useCompass(observation, time);
  if (dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(&observation)) return useScan(observation, time);
  return useLandmarks(observation, time);
}

std::string RawlogTranslator::useOdometry(const mrpt::obs::CObservation& observation, double time)
{
  const std::string label = labelOf(observation);
  if (odometry_source_.empty()) odometry_source_ = label;
  if (odometry_source_ != label) return "a second source of odometry";
  const Pose2 pose = planar(dynamic_cast<const mrpt::obs::CObservationOdometry&>(observation).odometry);
  if (!isFinite(pose)) return "not finite";
  emit(OdometryRecord{time, pose});
  return "";
}

std::string RawlogTranslator::useCompass(const mrpt::obs::CObservation& observation, double time)
{
  const auto& imu = dynamic_cast<const mrpt::obs::CObservationIMU&>(observation);
  if (!isTrue(imu.dataIsPresent.at(mrpt::obs::IMU_YAW))) return "no absolute yaw";
  const double heading = imu.rawMeasurements.at(mrpt::obs::IMU_YAW) - imu.sensorPose.yaw();
  if (!std::isfinite(heading)) return "not finite";
  emit(CompassRecord{.time = time, .sensor = labelOf(observation), .heading = wrap(heading), .std_heading = 0});
  return "";
}

std::string RawlogTranslator::useScan(const mrpt::obs::CObservation& observation, double time)
{
  const std::string label = labelOf(observation);
  if (!scans_ || !scans_(label)) return "of sensor '" + label + "', whose section has no extract = reflectors";
  RangeScan scan = toRangeScan(dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(observation));
  if (scan.intensities.empty()) return "without intensities";
  const bool finite =
      isFinite(scan.T_robot_sensor) && std::isfinite(scan.sensor_height) && std::isfinite(scan.bearing_step);
  if (!finite) return "not finite";
  scan.time = time;
  emit(std::move(scan));
  return "";
}

std::string RawlogTranslator::useLandmarks(const mrpt::obs::CObservation& observation, double time)
{
  auto measurements = toMeasurements(observation);
  if (!measurements) return "not about landmarks or motion";
  std::string why_nothing = "no detections";
  bool used = false;
  for (Reading& reading : measurements->readings)
  {
    reading.time = time;
    why_nothing = useReading(std::move(reading), shortClassName(observation));
    used = used || why_nothing.empty();
  }
  for (RunningFixReading& fix : measurements->fixes)
  {
    fix.time = time;
    why_nothing = whyUnusable(fix);
    used = used || why_nothing.empty();
    if (why_nothing.empty()) emit(std::move(fix));
  }
  return used ? "" : why_nothing;
}

std::string RawlogTranslator::useReading(Reading reading, const std::string& class_name)
{
  if (!isFinite(reading.T_robot_sensor) || !std::isfinite(reading.sensor_height)) return "sensor pose not finite";
  const std::size_t before = reading.detections.size();
  UnusableCounts reasons;
  removeUnusable(reading, reasons);
  for (const auto& [reason, number] : reasons) unusable_[class_name + ": " + reason] += number;
  if (before > 0 && reading.detections.empty()) return "no usable detection";
  emit(std::move(reading));
  return "";
}

void RawlogTranslator::count(const std::string& class_name, const std::string& why_ignored)
{
  ObservationCount& counted = observations_[class_name];
  ++counted.total;
  ++(why_ignored.empty() ? counted.used : counted.ignored);
  if (!why_ignored.empty()) ++unusable_[class_name + ": " + why_ignored];
}

std::vector<RawlogTranslator::Output> RawlogTranslator::finish()
{
  output_.clear();
  step_.reset();
  if (clock_.step)
    for (PendingAction& action : pending_actions_) action.time.reset();
  for (const PendingAction& action : pending_actions_) count(action.class_name, action.time ? "" : kNoTime);
  if (!pending_actions_.empty() && pending_actions_.back().time)
    emit(OdometryRecord{*pending_actions_.back().time, dead_reckoned_});
  pending_actions_.clear();
  return std::move(output_);
}
}  // namespace mrpt_ext
