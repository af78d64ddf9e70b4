#include "mrpt_ext/simulation/simulator.h"

#include <algorithm>

#include "mrpt_ext/simulation/odometry_simulator.h"
#include "mrpt_ext/simulation/rounding.h"
#include "mrpt_ext/simulation/running_fix_simulator.h"
#include "mrpt_ext/simulation/sensor_simulator.h"

namespace mrpt_ext
{
namespace
{
/// Numbers of the random streams of one seed.
enum Stream : std::uint64_t
{
  kMapStream = 0,
  kPathStream = 1,
  kOdometryStream = 2,
  kFirstObjectStream = 1000,
  kFirstSensorStream = 2000
};

class Simulation
{
 public:
  explicit Simulation(const Scenario& scenario)
      : scenario_(scenario),
        map_(planned<LandmarkTable>(kMapStream, [&](RandomStream& r) { return generateMap(scenario.map, r); })),
        path_(planned<RobotPath>(kPathStream,
                                 [&](RandomStream& r) { return planPath(scenario.path, scenario.duration, r); })),
        odometry_(planned<DeadReckoning>(kOdometryStream, [&](RandomStream& r)
                                         { return DeadReckoning(path_, scenario.odometry, scenario.duration, r); }))
  {
    for (std::size_t i = 0; i < scenario.objects.size(); ++i)
      object_paths_.push_back(planned<RobotPath>(kFirstObjectStream + i, [&](RandomStream& r)
                                                 { return planPath(scenario.objects[i].path, scenario.duration, r); }));
  }

  Recording play(const std::function<void(double)>& progress)
  {
    Recording recording;
    recording.map = map_;
    for (const TimedPose& record : odometry_.records())
      if (record.time <= scenario_.duration)
        recording.records.push_back(OdometryRecord{stamp(record.time), record.pose});
    for (std::size_t i = 0; i < scenario_.sensors.size(); ++i)
    {
      runSensor(scenario_.sensors[i], RandomStream(scenario_.random_seed, kFirstSensorStream + i), recording.records);
      if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(scenario_.sensors.size()));
    }
    // Stable: at one time odometry comes first, then the sensors in the order of the scenario.
    std::stable_sort(recording.records.begin(), recording.records.end(),
                     [](const Record& a, const Record& b) { return timeOf(a) < timeOf(b); });
    recording.truth = truth();
    return recording;
  }

 private:
  template <class Result, class Plan>
  Result planned(std::uint64_t stream, const Plan& plan) const
  {
    RandomStream random(scenario_.random_seed, stream);
    return plan(random);
  }

  [[nodiscard]] double stamp(double time) const { return rounded(scenario_.start_time + time); }

  [[nodiscard]] Pose2 robotAt(double time) const
  {
    Pose2 T_map_path;
    for (const Kidnapping& kidnapping : scenario_.kidnappings)
      if (kidnapping.time <= time) T_map_path = compose(kidnapping.pose, inverse(path_.poseAt(kidnapping.time)));
    return compose(T_map_path, path_.poseAt(time));
  }

  [[nodiscard]] std::vector<Feature> featuresAt(double time) const
  {
    std::vector<Feature> features;
    for (const Landmark& landmark : map_.all())
      features.push_back({landmark.id, landmark.category, landmark.position, true});
    for (std::size_t i = 0; i < object_paths_.size(); ++i)
    {
      const Pose2 pose = object_paths_[i].poseAt(time);
      features.push_back({kNoId, scenario_.objects[i].category, {pose.x, pose.y, scenario_.objects[i].z}, false});
    }
    return features;
  }

  void runSensor(const SimulatedSensor& sensor, RandomStream random, std::vector<Record>& records) const
  {
    RunningFixSimulator fixes(sensor, path_, odometry_, random);
    for (int tick = 0;; ++tick)
    {
      const double time = sensor.phase_s + tick / sensor.rate_hz;
      if (time > scenario_.duration) return;
      const Pose2 robot = robotAt(time);
      if (sensor.kind == SensorKind::compass)
      {
        CompassRecord record = simulateCompass(sensor, robot, random);
        record.time = stamp(time + sensor.delay_s);
        records.push_back(record);
      }
      else if (sensor.kind == SensorKind::running_fix)
      {
        auto fix = fixes.look(time, robot, featuresAt(time));
        if (!fix) continue;
        fix->time = stamp(fix->time + sensor.delay_s);
        fix->first_time = stamp(fix->first_time + sensor.delay_s);
        records.push_back(*fix);
      }
      else
      {
        Reading reading = simulateReading(sensor, robot, featuresAt(time), random);
        reading.time = stamp(time + sensor.delay_s);
        records.push_back(reading);
      }
    }
  }

  [[nodiscard]] Trajectory truth() const
  {
    Trajectory truth;
    for (int tick = 0;; ++tick)
    {
      const double time = std::min(tick / scenario_.truth_rate_hz, scenario_.duration);
      truth.push_back({stamp(time), rounded(robotAt(time))});
      if (time >= scenario_.duration) return truth;
    }
  }

  const Scenario& scenario_;
  LandmarkTable map_;
  RobotPath path_;
  DeadReckoning odometry_;
  std::vector<RobotPath> object_paths_;
};
}  // namespace

Recording simulate(const Scenario& scenario, const std::function<void(double)>& progress)
{
  return Simulation(scenario).play(progress);
}
}  // namespace mrpt_ext
