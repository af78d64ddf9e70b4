#include "mrpt_ext/diagnosis/calibration_data.h"

#include <algorithm>
#include <functional>
#include <set>

#include "mrpt_ext/diagnosis/commanded_odometry.h"
#include "mrpt_ext/diagnosis/configured_model.h"
#include "mrpt_ext/diagnosis/detection_association.h"
#include "mrpt_ext/diagnosis/link_noise.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStep = 1;          // [s] longest time between two poses
constexpr double kLongestGap = 180;  // [s] that odometry bridges
constexpr std::size_t kMostReadings = 100'000;
constexpr std::size_t kMostPlaced = 12;                     // landmarks, for errors of the map
constexpr std::size_t kMostRadios = 50, kLeastRanges = 20;  // ranges: per radio, on average

class CalibrationDataBuilder
{
 public:
  CalibrationDataBuilder(const LocalizationInput& input)
      : input_(input), noise_(input.config.filter.motion, input.log.overview.odometry)
  {
    for (const TimedPose& entry : input.log.overview.odometry.trajectory())
      result_.problem.odometry.push_back({entry.time, entry.pose});
    result_.sensors = input.logged_sensors;
    result_.problem.sensors = result_.sensors.size();
    result_.identified.assign(result_.sensors.size(), true);
    for (std::size_t i = 0; i < input.context.map.size(); ++i) result_.ids.push_back(input.context.map[i].id);
    for (const std::string& label : result_.sensors)
      result_.problem.lever_arm_std.push_back(
          configOf(input.config.frames.sensors, label).lever_arm_std.value_or(kAssumedLeverArmStd));
  }

  void add(const Frame& frame, const PoseEstimate& estimate)
  {
    result_.compass = result_.compass || frame.compass.has_value();
    GaussianPose robot = estimate.pose;
    robot.mean = compose(robot.mean, moved(estimate.time, frame.time).increment);
    bridgeTo(frame.time);
    addPose(frame.time, robot.mean);
    for (const Reading& reading : frame.readings)
      for (const Detection& detection : reading.detections) addDetection(detection, reading, robot);
  }
  [[nodiscard]] bool isFull() const
  {
    return std::max(result_.problem.readings.size(), mixtures_.size()) >= kMostReadings;
  }
  /// With the ambiguous detections where most are.
  [[nodiscard]] CalibrationData take()
  {
    std::vector<CalibrationReading>& readings = result_.problem.readings;
    if (mixtures_.size() > readings.size())
    {
      readings.insert(readings.end(), mixtures_.begin(), mixtures_.end());
      std::stable_sort(readings.begin(), readings.end(),
                       [](const CalibrationReading& a, const CalibrationReading& b) { return a.pose < b.pose; });
      result_.ambiguous -= mixtures_.size() / 2;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] OdometryMotion moved(double from, double to) const
  {
    return nominalMotion(input_.config.filter.motion, input_.log.overview.odometry.between(from, to));
  }

  void bridgeTo(double time)
  {
    if (result_.problem.poses.empty() || input_.config.frames.independent) return;
    if (time - result_.problem.poses.back().time > kLongestGap) return;
    while (time - result_.problem.poses.back().time > 1.5 * kStep)
    {
      const TrajectoryPose last = result_.problem.poses.back();
      addPose(last.time + kStep, compose(last.pose, moved(last.time, last.time + kStep).increment));
    }
  }

  void addPose(double time, const Pose2& pose)
  {
    TrajectoryPose next{time, pose, {}};
    if (!result_.problem.poses.empty() && !input_.config.frames.independent)
    {
      const double before = result_.problem.poses.back().time;
      if (time - before <= kLongestGap) next.since_previous = noise_.covariances(before, time);
    }
    result_.problem.poses.push_back(next);
  }

  void addDetection(const Detection& detection, const Reading& reading, const GaussianPose& robot)
  {
    const LandmarkTable& map = input_.context.map;
    const DetectionMatch match = matchOf(detection, reading, map, robot);
    const std::optional<std::size_t> landmark = match.landmark;
    const auto label = std::find(result_.sensors.begin(), result_.sensors.end(), reading.sensor);
    const auto sensor = static_cast<std::size_t>(label - result_.sensors.begin());
    if (!landmark)
    {
      if (match.none)
        addUnmatched(detection, sensor);
      else
        addAmbiguous(detection, reading, robot, sensor);
      return;
    }
    if (detection.id == kNoId) result_.identified[sensor] = false;
    CalibrationReading r = readingOf(*landmark, reading, sensor);
    if (detection.bearing) add(result_.problem.readings, r, false, *detection.bearing, detection.std_bearing);
    r.off_axis = offAxis(detection, sensor);
    if (detection.range) add(result_.problem.readings, r, true, *detection.range, detection.std_range);
  }

  void addAmbiguous(const Detection& detection, const Reading& reading, const GaussianPose& robot, std::size_t sensor)
  {
    ++result_.ambiguous;
    const std::optional<LandmarkMixture> mixture = mixtureOf(detection, reading, input_.context.map, robot);
    if (!mixture) return;
    CalibrationReading r = readingOf(mixture->likeliest, reading, sensor);
    r.landmark = mixture->mean;
    add(mixtures_, r, false, *detection.bearing, mixture->std_bearing);
    r.off_axis = offAxis(detection, sensor);
    add(mixtures_, r, true, *detection.range, mixture->std_range);
  }

  /// Of a landmark, without what was measured.
  [[nodiscard]] CalibrationReading readingOf(std::size_t landmark, const Reading& reading, std::size_t sensor) const
  {
    const Vector3d position = input_.context.map[landmark].position;
    return {.pose = result_.problem.poses.size() - 1,
            .sensor = sensor,
            .landmark = position.head<2>(),
            .landmark_number = landmark,
            .T_robot_sensor = reading.T_robot_sensor,
            .height = reading.horizontal_range ? 0 : position.z() - reading.sensor_height};
  }

  [[nodiscard]] std::optional<double> offAxis(const Detection& detection, std::size_t sensor) const
  {
    if (!detection.bearing) return std::nullopt;
    const SensorConfig& config = configOf(input_.config.frames.sensors, result_.sensors[sensor]);
    return wrap(loggedBearing(*detection.bearing, config) - config.range_axis);
  }

  static void add(std::vector<CalibrationReading>& readings, CalibrationReading r, bool is_range, double value,
                  double std)
  {
    r.is_range = is_range;
    r.value = value;
    r.std = std;
    readings.push_back(r);
  }

  void addUnmatched(const Detection& detection, std::size_t sensor)
  {
    const std::size_t pose = result_.problem.poses.size() - 1;
    if (detection.bearing) result_.unmatched.push_back({pose, sensor, false});
    if (detection.range) result_.unmatched.push_back({pose, sensor, true});
  }

  const LocalizationInput& input_;
  LinkNoise noise_;
  CalibrationData result_;
  std::vector<CalibrationReading> mixtures_;  // of detections that one of several landmarks may have caused
};

/// Landmarks that the sensor ranges to; none where they are too many to have an offset each.
std::set<std::size_t> radiosOf(const CalibrationData& data, std::size_t sensor)
{
  std::set<std::size_t> radios;
  std::size_t ranges = 0;
  for (const CalibrationReading& r : data.problem.readings)
  {
    if (r.sensor != sensor || !r.is_range) continue;
    radios.insert(r.landmark_number);
    ++ranges;
  }
  if (radios.size() > kMostRadios || ranges < kLeastRanges * radios.size()) radios.clear();
  return radios;
}

bool measuresDepths(const CalibrationData& data, std::size_t sensor)
{
  return std::any_of(data.depths.begin(), data.depths.end(),
                     [sensor](const DepthHypothesis& hypothesis)
                     { return hypothesis.sensor == sensor && hypothesis.likelier; });
}

std::vector<bool> areDepths(const CalibrationData& data, const SensorConfigs& sensors)
{
  std::vector<bool> depths;
  for (const std::string& label : data.sensors) depths.push_back(configOf(sensors, label).range_along_axis);
  return depths;
}
}  // namespace

std::set<std::string> sensorsWithBearings(const CalibrationData& data)
{
  std::set<std::string> labels;
  for (const CalibrationReading& r : data.problem.readings)
    if (!r.is_range) labels.insert(data.sensors[r.sensor]);
  return labels;
}

CalibrationData collectCalibrationData(const LocalizationInput& input, const std::vector<PoseEstimate>& trajectory)
{
  constexpr double kRounding = 1e-6;  // [s]
  CalibrationDataBuilder builder(input);
  FrameOptions by_stamp = input.config.frames;
  by_stamp.window = 0;
  const double window = input.config.frames.window;
  const FrameStream frames = streamOf(input, by_stamp);
  while (const auto frame = frames())
  {
    const auto estimate = std::lower_bound(trajectory.begin(), trajectory.end(), frame->time - kRounding,
                                           [](const PoseEstimate& point, double time) { return point.time < time; });
    if (estimate != trajectory.end() && estimate->time - frame->time <= window + kRounding && !frame->readings.empty())
      builder.add(*frame, *estimate);
    if (builder.isFull()) break;
  }
  CalibrationData data = builder.take();
  data.verified = std::any_of(trajectory.begin(), trajectory.end(),
                              [](const PoseEstimate& point) { return point.verdict == Verdict::ok; });
  data.commanded = isCommanded(input.log.overview.odometry.trajectory());
  std::vector<CalibrationUnknown> unknowns = calibrationUnknowns(input, data);
  std::erase_if(unknowns, [](const CalibrationUnknown& unknown) { return isOfRegime(unknown.parameter); });
  data.depths = chooseDepths(data.problem, areDepths(data, input.config.frames.sensors), unknowns,
                             configuredModel(data.sensors, {}, input.config));
  return data;
}

std::optional<LocalizationInput> withLikelierDepths(const LocalizationInput& input, const CalibrationData& data)
{
  std::optional<LocalizationInput> other;
  for (const DepthHypothesis& depths : data.depths)
  {
    if (!depths.differs()) continue;
    if (!other) other = input;
    const std::string& label = data.sensors[depths.sensor];
    SensorConfig config = configOf(input.config.frames.sensors, label);
    config.range_along_axis = depths.likelier;
    other->config.frames.sensors[label] = config;
  }
  return other;
}

bool lookAgain(const LocalizationInput& likelier, const std::vector<PoseEstimate>& trajectory, CalibrationData& data)
{
  CalibrationData again = collectCalibrationData(likelier, trajectory);
  if (std::any_of(again.depths.begin(), again.depths.end(), std::mem_fn(&DepthHypothesis::differs))) return false;
  again.depths = std::move(data.depths);
  data = std::move(again);
  return true;
}

std::vector<CalibrationUnknown> calibrationUnknowns(const LocalizationInput& input, const CalibrationData& data)
{
  using enum CalibrationParameter;
  const bool moving = !input.config.frames.independent && !data.problem.odometry.empty() &&
                      input.config.filter.motion.type != MotionType::random_walk;
  std::set<std::size_t> bearings, ranges, placed;
  for (const CalibrationReading& r : data.problem.readings) (r.is_range ? ranges : bearings).insert(r.sensor);
  std::vector<CalibrationUnknown> unknowns;
  if (moving) unknowns = {{distance_scale}, {rotation_scale}, {veer}};
  if (moving && mayDrift(data.commanded, input.config)) unknowns.push_back({drift});
  // How a robot follows commands depends on the motion. Where odometry is measured, noise would be turns, and a record
  // with much of it a turn in place.
  const OdometryCorrection& now = input.config.frames.odometry;
  if (moving && (data.commanded || now.distance_per_turn != 0)) unknowns.push_back({distance_per_turn});
  if (moving && (data.commanded || now.pivot_scale != 1)) unknowns.push_back({pivot_scale});
  for (std::size_t s = 0; s < data.sensors.size(); ++s)
  {
    const bool measures = bearings.count(s) > 0 || ranges.count(s) > 0;
    if (moving && measures) unknowns.push_back({delay, s});
    if (moving && measures && data.problem.lever_arm_std[s] > 0)
    {
      unknowns.push_back({lever_arm_x, s});
      unknowns.push_back({lever_arm_y, s});
    }
    if (bearings.count(s) > 0) unknowns.push_back({bearing_offset, s});
    if (bearings.count(s) > 0 && looksAhead(data.problem, s)) unknowns.push_back({bearing_scale, s});
    if (ranges.count(s) == 0) continue;
    unknowns.push_back({range_offset, s});
    unknowns.push_back({range_scale, s});
    if (measuresDepths(data, s)) unknowns.push_back({range_axis, s});
    if (bearings.count(s) > 0 || !data.identified[s]) continue;
    const std::set<std::size_t> radios = radiosOf(data, s);
    for (const std::size_t landmark : radios)
    {
      unknowns.push_back({landmark_offset, s, landmark});
      if (radios.size() > kMostPlaced || !placed.insert(landmark).second) continue;
      unknowns.push_back({landmark_x, s, landmark});
      unknowns.push_back({landmark_y, s, landmark});
    }
  }
  return unknowns;
}
}  // namespace mrpt_ext
