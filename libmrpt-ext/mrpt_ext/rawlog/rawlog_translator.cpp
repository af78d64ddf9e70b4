#include "mrpt_ext/rawlog/rawlog_translator.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>

#include "mrpt_ext/observations/logged_flag.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/timestamps.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kActions = "actions";
constexpr const char* kNoTime = "no time stamp";

Pose2 planar(const mrpt::poses::CPose2D& pose) { return {pose.x(), pose.y(), pose.phi()}; }

/// Increment in the frame of the robot before the action.
std::optional<Pose2> incrementOf(const mrpt::obs::CAction& action)
{
  if (const auto* move = dynamic_cast<const mrpt::obs::CActionRobotMovement2D*>(&action))
    return planar(move->estimationMethod == mrpt::obs::CActionRobotMovement2D::emOdometry
                      ? move->rawOdometryIncrementReading
                      : move->poseChange->getMeanVal());
  if (const auto* move = dynamic_cast<const mrpt::obs::CActionRobotMovement3D*>(&action))
    return planar(mrpt::poses::CPose2D(move->poseChange.mean));
  return std::nullopt;
}

std::optional<double> timeOf(const mrpt::system::TTimeStamp& stamp)
{
  return isValid(stamp) ? std::optional(secondsOf(stamp)) : std::nullopt;
}

std::optional<double> latestTime(const mrpt::obs::CSensoryFrame& frame)
{
  std::optional<double> latest;
  for (const auto& observation : frame)
    if (const auto time = timeOf(observation->timestamp)) latest = std::max(latest.value_or(*time), *time);
  return latest;
}
}  // namespace

const std::set<std::string>& translatedClasses()
{
  static const std::set<std::string> kClasses = {"CObservationOdometry",         "CObservationIMU",
                                                 "CObservationLandmarkBearings", "CObservationStereoRanges",
                                                 "CObservationBearingRange",     "CObservationBeaconRanges",
                                                 "CObservationRunningFix"};
  return kClasses;
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
  const auto increment = incrementOf(action);
  if (!increment) return count(name, "not a robot movement");
  if (odometry_source_.empty())
  {
    odometry_source_ = kActions;
    if (first_frame_time_) emit(OdometryRecord{*first_frame_time_, dead_reckoned_});
  }
  if (odometry_source_ != kActions) return count(name, "a second source of odometry");
  if (!isFinite(*increment)) return count(name, "not finite");
  dead_reckoned_ = compose(dead_reckoned_, *increment);
  pending_actions_.push_back({name, timeOf(action.timestamp)});
}

void RawlogTranslator::readFrame(const mrpt::obs::CSensoryFrame& frame)
{
  auto time = latestTime(frame);
  if (!pending_actions_.empty())
  {
    if (!time) time = pending_actions_.back().time;
    step_ = step_times_.size();
    step_times_.push_back(time.value_or(step_times_.empty() ? 0 : step_times_.back()));
    for (const PendingAction& action : pending_actions_) count(action.class_name, time ? "" : kNoTime);
    pending_actions_.clear();
  }
  if (odometry_source_.empty()) first_frame_time_ = time;
  if (time && odometry_source_ == kActions) emit(OdometryRecord{*time, dead_reckoned_});
  for (const auto& observation : frame) readObservation(*observation, time);
}

void RawlogTranslator::readObservation(const mrpt::obs::CObservation& observation, std::optional<double> frame_time)
{
  const auto own_time = timeOf(observation.timestamp);
  const auto time = own_time ? own_time : frame_time;
  count(shortClassName(observation), time ? useObservation(observation, *time) : kNoTime);
}

std::string RawlogTranslator::useObservation(const mrpt::obs::CObservation& observation, double time)
{
  if (dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation)) return useOdometry(observation, time);
  if (dynamic_cast<const mrpt::obs::CObservationIMU*>(&observation)) return useCompass(observation, time);
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
  for (const PendingAction& action : pending_actions_) count(action.class_name, action.time ? "" : kNoTime);
  if (!pending_actions_.empty() && pending_actions_.back().time)
    emit(OdometryRecord{*pending_actions_.back().time, dead_reckoned_});
  pending_actions_.clear();
  return std::move(output_);
}
}  // namespace mrpt_ext
