#include "mrpt_ext/diagnosis/innovation_observer.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "mrpt_ext/diagnosis/bias_parameter.h"
#include "mrpt_ext/diagnosis/commanded_odometry.h"
#include "mrpt_ext/diagnosis/detection_association.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostSensors = 8;         // that are looked at
constexpr std::size_t kMostComparisons = 5000;  // of detections with landmarks, per frame
constexpr double kGate = 4, kLeaves = 6;        // standard deviations
constexpr double kHeadingKnown = 0.5;           // [rad] standard deviation
constexpr double kSmoothing = 1;                // [s] over which odometry is averaged for the sensitivities
constexpr double kWarmUp = 5;                   // [s] until the sensitivities have forgotten the start
constexpr double kLeastRange = 0.5;             // [m] below which ranges are no longer linear in squared heights
constexpr double kFromMode = 4;                 // variance at the start over that of the mode

bool hasUsableOdometry(const LocalizationInput& input)
{
  return !input.log.overview.odometry.empty() && !input.config.frames.independent &&
         input.config.filter.motion.type != MotionType::random_walk;
}

bool isEstimated(const CalibrationUnknown& unknown, const LocalizationInput& input)
{
  return std::any_of(input.config.biases.begin(), input.config.biases.end(),
                     [&](const BiasState& bias)
                     { return isTheSame(bias, unknown, input.logged_sensors[unknown.sensor]); });
}

std::size_t comparisons(const Frame& frame, std::size_t landmarks)
{
  std::size_t count = 0;
  for (const Reading& reading : frame.readings)
    for (const Detection& detection : reading.detections) count += detection.id == kNoId ? landmarks : 1;
  return count;
}
}  // namespace

PossibleErrors possibleErrors(const LocalizationInput& input)
{
  using enum CalibrationParameter;
  std::vector<CalibrationUnknown> all;
  if (hasUsableOdometry(input))
  {
    all = {{distance_scale}, {rotation_scale}, {veer}};
    if (mayDrift(isCommanded(input.log.overview.odometry.trajectory()), input.config)) all.push_back({drift});
  }
  for (std::size_t s = 0; s < std::min(input.logged_sensors.size(), kMostSensors); ++s)
  {
    for (const CalibrationParameter parameter : {bearing_offset, range_offset, range_scale, range_height})
      all.push_back({parameter, s});
  }
  const auto middle = std::stable_partition(
      all.begin(), all.end(), [&](const CalibrationUnknown& unknown) { return isEstimated(unknown, input); });
  return {all, static_cast<std::size_t>(middle - all.begin())};
}

InnovationObserver::InnovationObserver(const LocalizationInput& input)
    : InnovationObserver(input, possibleErrors(input))
{
}

InnovationObserver::InnovationObserver(const LocalizationInput& input, PossibleErrors possible)
    : input_(input),
      unknowns_(std::move(possible.unknowns)),
      filter_(unknowns_, input.config.filter.motion),
      noise_(input.config.filter.motion, input.log.overview.odometry),
      regression_(unknowns_, possible.nuisances)
{
  if (hasUsableOdometry(input)) delays_.emplace(input.log.overview.odometry, input.config.filter.motion);
}

bool InnovationObserver::follows(const FilterStep& step) const
{
  const GaussianPose& mode = step.modes.modes.front().pose;
  const Vector2d apart = mode.mean.position() - filter_.pose().mean.position();
  const Matrix2d spread =
      (mode.covariance + filter_.pose().covariance).topLeftCorner<2, 2>() + Matrix2d::Identity() * 1e-6;
  return apart.dot(spread.inverse() * apart) < square(kLeaves);
}

void InnovationObserver::add(const Frame& frame, const FilterStep& step)
{
  if (input_.config.frames.independent) return;
  if (delays_)
  {
    const Matrix3d noise = scattered(noise_.covariances(frame.time - frame.motion.duration, frame.time));
    filter_.predict(frame.motion, smoothMotion(frame), noise);
    delays_->predict(frame.time);
  }
  else
    filter_.predict(frame.motion);
  const bool usable = step.verdict != Verdict::lost && !step.modes.modes.empty() && !step.reseeded;
  if (running_) running_ = usable;
  if (!running_)
  {
    running_ = usable && step.verdict == Verdict::ok;
    if (!running_) return;
    GaussianPose start = step.modes.modes.front().pose;
    start.covariance *= kFromMode;
    filter_.start(start);
    if (delays_) delays_->start(start, frame.time);
    started_ = frame.time;
    return;  // the frame is in the mode already
  }
  if (frame.readings.empty()) return;
  warm_ = frame.time - started_ > kWarmUp;
  const std::size_t stride = 1 + comparisons(frame, input_.context.map.size()) / kMostComparisons;
  for (const Reading& reading : frame.readings) add(reading, stride);
  if (warm_) regression_.endFrame(filter_);
  if (delays_) delays_->endFrame(warm_);
  running_ = follows(step);
}

void InnovationObserver::add(const Reading& reading, std::size_t stride)
{
  SensorInnovations& sensor = sensors_[reading.sensor];
  sensor.clutter_probability = reading.model.clutter_probability;
  const GaussianPose predicted = filter_.pose();
  for (std::size_t k = 0; k < reading.detections.size(); k += stride)
  {
    const Detection& detection = reading.detections[k];
    const DetectionMatch match = matchOf(detection, reading, input_.context.map, predicted);
    sensor.detections.add(match.landmark ? observe(detection, reading, *match.landmark) : match.none);
  }
}

bool InnovationObserver::observe(const Detection& detection, const Reading& reading, std::size_t number)
{
  const Landmark& landmark = input_.context.map[number];
  const Vector2d position = landmark.position.head<2>();
  const bool heading_known = filter_.pose().covariance(2, 2) < square(kHeadingKnown);
  const double map_std = landmark.stddev.norm() / std::sqrt(2.0);
  MatchedMeasurement matched{.landmark = position, .T_robot_sensor = reading.T_robot_sensor};
  bool outlier = false;
  const double flat = predictRange(filter_.pose().mean, position, reading.T_robot_sensor);
  if (detection.bearing && heading_known && flat > 0)
  {
    matched.value = *detection.bearing;
    matched.std = std::hypot(detection.std_bearing, map_std / flat);
    outlier = take(matched, reading.sensor, heading_known);
  }
  if (detection.range)
  {
    matched.is_range = true;
    matched.value = *detection.range;
    matched.std = std::hypot(detection.std_range, map_std);
    matched.height = reading.horizontal_range ? 0 : landmark.position.z() - reading.sensor_height;
    outlier = take(matched, reading.sensor, heading_known) || outlier;
  }
  return outlier;
}

bool InnovationObserver::take(const MatchedMeasurement& matched, const std::string& label, bool heading_known)
{
  ScalarMeasurement measurement = linearize(matched, filter_.pose().mean);
  measurement.unknown = sensitivity(label, matched.is_range, matched.value - measurement.residual);
  if (!heading_known) measurement.pose[2] = 0;
  SensorInnovations& sensor = sensors_[label];
  InnovationStatistics& statistics = matched.is_range ? sensor.ranges : sensor.bearings;
  const SensitiveInnovation found = filter_.innovation(measurement);
  const bool outlier = std::abs(found.value) > kGate * std::max(1.0, statistics.scatter());
  if (warm_) statistics.add(found.value);
  if (outlier) return true;
  if (warm_) regression_.add(found);
  filter_.update(measurement);
  if (delays_) delays_->update(matched, warm_);
  return false;
}

Eigen::RowVectorXd InnovationObserver::sensitivity(const std::string& sensor, bool is_range, double predicted) const
{
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(unknowns_.size()));
  for (std::size_t k = 0; k < unknowns_.size(); ++k)
  {
    if (isOfOdometry(unknowns_[k].parameter) || input_.logged_sensors[unknowns_[k].sensor] != sensor) continue;
    double& value = row[static_cast<Eigen::Index>(k)];
    if (unknowns_[k].parameter == CalibrationParameter::bearing_offset && !is_range) value = 1;
    if (unknowns_[k].parameter == CalibrationParameter::range_offset && is_range) value = 1;
    if (unknowns_[k].parameter == CalibrationParameter::range_scale && is_range) value = predicted;
    if (unknowns_[k].parameter == CalibrationParameter::range_height && is_range)
      value = 0.5 / std::max(predicted, kLeastRange);
  }
  return row;
}

OdometryMotion InnovationObserver::smoothMotion(const Frame& frame) const
{
  const OdometryPath& odometry = input_.log.overview.odometry;
  const double lasted = frame.motion.duration, middle = frame.time - lasted / 2,
               half = std::max(kSmoothing, lasted) / 2, share = lasted / (2 * half);
  OdometryMotion smooth = odometry.between(middle - half, middle + half);
  const double turned = odometry.between(middle - half, frame.time - lasted).increment.phi;
  const Vector2d step = rotation(-turned) * smooth.increment.position() * share;
  smooth.increment = {step.x(), step.y(), smooth.increment.phi * share};
  smooth.path_length *= share;
  smooth.duration = lasted;
  smooth.moments.reset();
  return smooth;
}

std::optional<DelayFinding> InnovationObserver::delay() const { return delays_ ? delays_->finding() : std::nullopt; }
}  // namespace mrpt_ext
