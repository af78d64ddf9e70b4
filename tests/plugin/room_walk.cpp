#include "room_walk.h"

#include <cmath>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr double kStartTime = 1'700'000'000.1;
constexpr double kStdBearing = 2 * kPi / 180;

LandmarkTable roomMap(RandomStream& random)
{
  std::vector<Landmark> landmarks;
  for (int id = 1; id <= 12; ++id)
    landmarks.push_back({.id = id, .position = {random.uniform(-4.5, 4.5), random.uniform(-4.5, 4.5), 0}});
  return LandmarkTable(landmarks);
}

Pose2 truthAt(double t) { return {2 * std::cos(0.2 * t), 2 * std::sin(0.2 * t), wrap(0.2 * t + kPi / 2)}; }

Reading observe(const LandmarkTable& map, double t, RandomStream& random)
{
  Reading reading{.time = kStartTime + t, .sensor = "camera"};
  const Pose2 robot = truthAt(t);
  for (const Landmark& landmark : map.all())
  {
    const Vector2d line = landmark.position.head<2>() - robot.position();
    const double bearing = std::atan2(line.y(), line.x()) - robot.phi + kStdBearing * random.gaussian();
    reading.detections.push_back({.bearing = wrap(bearing), .std_bearing = kStdBearing});
  }
  return reading;
}

Reading measureRange(const LandmarkTable& map, double t, RandomStream& random)
{
  const double range = (map[0].position.head<2>() - truthAt(t).position()).norm() + 0.1 * random.gaussian();
  Reading reading{.time = kStartTime + t, .sensor = "stereo", .horizontal_range = true};
  reading.detections = {{.id = map[0].id, .range = range, .std_range = 0.1}};
  return reading;
}

RunningFixReading fix(const LandmarkTable& map, double t)
{
  const auto rangeAt = [&](double when) { return (map[1].position.head<2>() - truthAt(when).position()).norm(); };
  return {.time = kStartTime + t,
          .first_time = kStartTime + t - 1,
          .sensor = "goal",
          .horizontal_range = true,
          .id = map[1].id,
          .first_range = rangeAt(t - 1),
          .first_std = 0.05,
          .second_range = rangeAt(t),
          .second_std = 0.05,
          .displacement = between(truthAt(t - 1), truthAt(t)),
          .displacement_covariance = 1e-3 * Matrix3d::Identity()};
}
}  // namespace

Recording walkThroughRoom(double seconds)
{
  RandomStream random(20);
  Recording recording;
  recording.map = roomMap(random);
  Pose2 dead_reckoned;
  for (int tick = 0; tick * 0.2 < seconds; ++tick)
  {
    const double t = tick * 0.2;
    Pose2 step = tick == 0 ? Pose2{} : between(truthAt(t - 0.2), truthAt(t));
    step.x *= 1.02;
    step.phi += 0.005 * random.gaussian();
    dead_reckoned = compose(dead_reckoned, step);
    recording.truth.push_back({.time = kStartTime + t, .pose = truthAt(t)});
    recording.records.emplace_back(OdometryRecord{kStartTime + t, dead_reckoned});
    if (tick % 3 == 0) recording.records.emplace_back(observe(recording.map, t, random));
    if (tick % 10 == 9) recording.records.emplace_back(measureRange(recording.map, t, random));
    if (tick % 20 == 19) recording.records.emplace_back(fix(recording.map, t));
  }
  return recording;
}
}  // namespace mrpt_ext
