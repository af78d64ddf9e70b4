#include "mrpt_ext/simulation/simulated_drive.h"

#include <algorithm>
#include <utility>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/record_stream.h"
#include "mrpt_ext/simulation/odometry_simulator.h"
#include "mrpt_ext/simulation/random_errors.h"
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
  kBarrierStream = 3,
  kFirstObjectStream = 1000,
  kFirstSensorStream = 2000
};
}  // namespace

class SimulatedDrive::Simulation
{
 public:
  explicit Simulation(const Scenario& scenario)
      : scenario_(withRandomErrors(scenario)),
        map_(planned<LandmarkTable>(kMapStream, [&](RandomStream& r) { return generateMap(scenario.map, r); })),
        path_(planned<RobotPath>(kPathStream,
                                 [&](RandomStream& r) { return planPath(scenario.path, scenario.duration, r); })),
        odometry_(
            planned<SimulatedOdometry>(kOdometryStream, [&](RandomStream& r)
                                       { return SimulatedOdometry(path_, scenario_.odometry, scenario_.duration, r); }))
  {
    posts_ = planned<std::vector<Vector2d>>(kBarrierStream, [&](RandomStream& r) { return planPosts(r); });
    for (std::size_t i = 0; i < scenario.objects.size(); ++i)
      object_paths_.push_back(planned<RobotPath>(kFirstObjectStream + i, [&](RandomStream& r)
                                                 { return planPath(scenario.objects[i].path, scenario.duration, r); }));
    sources_.push_back({odometryRecords(), {}});
    for (std::size_t i = 0; i < scenario_.sensors.size(); ++i)
    {
      const auto run = std::make_shared<SensorRun>(*this, scenario_.sensors[i],
                                                   RandomStream(scenario.random_seed, kFirstSensorStream + i));
      sources_.push_back({[run] { return run->next(); }, {}});
    }
  }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The earliest next record of all sources. At one time odometry comes first, then the sensors in the order of the
  /// scenario.
  std::optional<Record> next()
  {
    Source* first = nullptr;
    for (Source& source : sources_)
    {
      if (!source.pending) source.pending = source.next();
      if (source.pending && (!first || timeOf(*source.pending) < timeOf(*first->pending))) first = &source;
    }
    return first ? std::exchange(first->pending, std::nullopt) : std::nullopt;
  }

  [[nodiscard]] const LandmarkTable& map() const { return map_; }

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

 private:
  template <class Result, class Plan>
  Result planned(std::uint64_t stream, const Plan& plan) const
  {
    RandomStream random(scenario_.random_seed, stream);
    return plan(random);
  }

  [[nodiscard]] std::vector<Vector2d> planPosts(RandomStream& random) const
  {
    const auto [low, high] = map_.boundingBox();
    return planBarriers(scenario_.barriers, low, high, path_, random);
  }

  [[nodiscard]] double stamp(double time) const { return rounded(scenario_.start_time + time); }

  [[nodiscard]] Pose2 robotAt(double time) const
  {
    Pose2 T_map_path;
    for (const Kidnapping& kidnapping : scenario_.kidnappings)
      if (kidnapping.time <= time) T_map_path = compose(kidnapping.pose, inverse(path_.poseAt(kidnapping.time)));
    return compose(T_map_path, path_.poseAt(time));
  }

  [[nodiscard]] std::vector<SceneFeature> featuresAt(double time) const
  {
    std::vector<SceneFeature> features;
    for (const Landmark& landmark : map_.all())
      features.push_back({landmark.id, landmark.category, landmark.position, true});
    for (std::size_t i = 0; i < object_paths_.size(); ++i)
    {
      const Pose2 pose = object_paths_[i].poseAt(time);
      const SimulatedObject& object = scenario_.objects[i];
      features.push_back({kNoId, object.category, {pose.x, pose.y, object.z}, false, object.radius});
    }
    for (const Vector2d& post : posts_)
      features.push_back({kNoId, {}, {post.x(), post.y(), map_.meanHeight()}, false, scenario_.barriers.post_radius});
    return features;
  }

  /// The same where a scanner that ends its scan at this time sees them from the robot: each from where the robot was
  /// when the beam met it.
  [[nodiscard]] std::vector<SceneFeature> featuresInScan(double end, const SimulatedSensor& sensor) const
  {
    constexpr int kIterations = 5;  // the bearing depends on the time, the time on the bearing
    std::vector<SceneFeature> features = featuresAt(end);
    if (!(sensor.sweep.duration > 0)) return features;
    const Pose2 robot = robotAt(end);
    for (SceneFeature& feature : features)
    {
      const Vector2d position = feature.position.head<2>();
      Pose2 then = robot;
      for (int k = 0; k < kIterations; ++k)
      {
        const double bearing = predictBearing(then, position, sensor.T_robot_sensor);
        then = robotAt(end - sensor.sweep.ageOf(bearing, sensor.field_of_view));
      }
      feature.position.head<2>() = transform(robot, transform(inverse(then), position));
    }
    return features;
  }

  RecordStream odometryRecords()
  {
    return [this, i = std::size_t{0}]() mutable -> std::optional<Record>
    {
      if (i == odometry_.records().size() || odometry_.records()[i].time > scenario_.duration) return std::nullopt;
      const TimedPose& record = odometry_.records()[i++];
      return OdometryRecord{stamp(record.time), record.pose};
    };
  }

  /// The measurements of one sensor, tick by tick.
  class SensorRun
  {
   public:
    SensorRun(const Simulation& simulation, const SimulatedSensor& sensor, const RandomStream& random)
        : simulation_(simulation),
          sensor_(sensor),
          random_(random),
          fixes_(sensor, simulation.path_, simulation.odometry_, random)
    {
    }

    std::optional<Record> next()
    {
      while (true)
      {
        const double time = sensor_.phase_s + tick_++ / sensor_.rate_hz;
        if (time > simulation_.scenario_.duration) return std::nullopt;
        if (auto record = measure(time)) return record;
      }
    }

   private:
    std::optional<Record> measure(double time)
    {
      const Pose2 robot = simulation_.robotAt(time);
      if (sensor_.kind == SensorKind::compass)
      {
        CompassRecord record = simulateCompass(sensor_, robot, random_);
        record.time = simulation_.stamp(time + sensor_.delay_s);
        return record;
      }
      if (sensor_.kind == SensorKind::running_fix)
      {
        auto fix = fixes_.measure(time, robot, simulation_.featuresAt(time));
        if (!fix) return std::nullopt;
        fix->time = simulation_.stamp(fix->time + sensor_.delay_s);
        fix->first_time = simulation_.stamp(fix->first_time + sensor_.delay_s);
        return *fix;
      }
      Reading reading = simulateReading(sensor_, robot, simulation_.featuresInScan(time, sensor_), random_);
      reading.time = simulation_.stamp(time + sensor_.delay_s);
      return reading;
    }

    const Simulation& simulation_;
    const SimulatedSensor& sensor_;
    RandomStream random_;
    RunningFixSimulator fixes_;
    int tick_ = 0;
  };

  /// Records of one origin, ordered by time, with the next one.
  struct Source
  {
    RecordStream next;
    std::optional<Record> pending;
  };

  Scenario scenario_;
  LandmarkTable map_;
  RobotPath path_;
  SimulatedOdometry odometry_;
  std::vector<RobotPath> object_paths_;
  std::vector<Vector2d> posts_;  // of the barriers
  std::vector<Source> sources_;
};

SimulatedDrive::SimulatedDrive(const Scenario& scenario) : simulation_(std::make_unique<Simulation>(scenario)) {}
SimulatedDrive::~SimulatedDrive() = default;
SimulatedDrive::SimulatedDrive(SimulatedDrive&&) noexcept = default;
std::optional<Record> SimulatedDrive::next() { return simulation_->next(); }
const LandmarkTable& SimulatedDrive::map() const { return simulation_->map(); }
Trajectory SimulatedDrive::truth() const { return simulation_->truth(); }

}  // namespace mrpt_ext
