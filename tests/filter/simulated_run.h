#pragma once

#include <algorithm>
#include <numeric>

#include "mrpt_ext/filter/particle_filter.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// Noise of the simulated robot and what it measures per frame.
struct SimulatedRobot
{
  Vector3d odometry_std{0.01, 0.01, 0.01};  ///< per step, body axes
  double std_bearing = degToRad(1);
  double std_range = 0.05;
  bool measures_range = false, measures_bearing = true;
  bool identified = true;
  std::size_t detections = 5;
  double clutter = 0.001;
  std::size_t false_detections = 0;  ///< per frame, anywhere, under any name
};

/// Motion model whose noise per step (one second, however long) is that of the robot.
inline MotionModel motionModelOf(const SimulatedRobot& robot)
{
  return {.std_xy_per_m = 0,
          .std_phi_per_deg = 0,
          .std_phi_per_m = 0,
          .std_xy_per_s = robot.odometry_std.x(),
          .std_phi_per_s = robot.odometry_std.z()};
}

inline LandmarkTable randomMap(std::size_t count, double side, RandomStream& random)
{
  std::vector<Landmark> landmarks;
  for (std::size_t i = 0; i < count; ++i)
    landmarks.push_back(
        {.id = static_cast<int>(i) + 1, .position = {random.uniform(0, side), random.uniform(0, side), 0}});
  return LandmarkTable(landmarks);
}

/// Motion of the k-th step of a round trip of about three metres radius.
inline Pose2 roundTripStep(int k) { return {0.05, 0, 0.05 / 3 + 0.01 * std::sin(0.05 * k)}; }

/// What the robot reports after moving by `increment` to `truth`.
inline Frame simulatedFrame(const SimulatedRobot& robot, const LandmarkTable& map, const Pose2& truth,
                            const Pose2& increment, RandomStream& random)
{
  const Vector3d& std = robot.odometry_std;
  Frame frame;
  frame.motion.increment = {increment.x + std.x() * random.gaussian(), increment.y + std.y() * random.gaussian(),
                            increment.phi + std.z() * random.gaussian()};
  frame.motion.path_length = increment.position().norm();
  frame.motion.turned = std::abs(increment.phi);
  frame.motion.duration = 1;
  Reading reading;
  reading.model.clutter_probability = robot.clutter;
  reading.model.max_range = 20.0;
  reading.model.lever_arm_std = 0;
  reading.model.delay_std = 0;
  std::vector<std::size_t> order(map.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < std::min(robot.detections, order.size()); ++i)
  {
    std::swap(order[i], order[i + random.below(order.size() - i)]);
    const Vector2d landmark = map[order[i]].position.head<2>();
    Detection detection{.id = robot.identified ? map[order[i]].id : kNoId};
    if (robot.measures_bearing)
    {
      detection.std_bearing = robot.std_bearing;
      detection.bearing = wrap(predictBearing(truth, landmark) + robot.std_bearing * random.gaussian());
    }
    if (robot.measures_range)
    {
      detection.std_range = robot.std_range;
      detection.range = predictRange(truth, landmark) + robot.std_range * random.gaussian();
    }
    reading.detections.push_back(detection);
  }
  frame.readings = {reading};
  return frame;
}

/// Adds the false detections of the robot to its only reading.
inline void addFalseDetections(const SimulatedRobot& robot, const LandmarkTable& map, Frame& frame,
                               RandomStream& random)
{
  for (std::size_t k = 0; k < robot.false_detections; ++k)
  {
    Detection detection = frame.readings.front().detections.front();
    if (robot.identified) detection.id = map[random.below(map.size())].id;
    if (detection.bearing) detection.bearing = random.uniform(-kPi, kPi);
    if (detection.range) detection.range = random.uniform(0.5, 14);
    frame.readings.front().detections.push_back(detection);
  }
}

/// A filter that knows the pose to 3 cm and 0.7 degrees.
inline ParticleSet particlesAt(const Pose2& pose, RandomStream& random)
{
  ParticleSet particles(Vector2d(5, 5));
  for (int i = 0; i < 300; ++i)
    particles.add({pose.x + 0.03 * random.gaussian(), pose.y + 0.03 * random.gaussian(),
                   pose.phi + degToRad(0.7) * random.gaussian()},
                  0);
  normalizeWeights(particles);
  return particles;
}

inline double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

/// A source without hypotheses.
inline HypothesisSet noProposals() { return {}; }
}  // namespace mrpt_ext
