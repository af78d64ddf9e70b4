#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// A robot with any sensor in any map, right or wrong: input that must not take long, whatever comes out.
struct RandomFrames
{
  int landmarks = 0, detections = 0;
  bool named = false, right = false, bearings = false, ranges = false, limited = false, standing = false;
  LandmarkTable map;
  PoseRegion region;
  std::vector<Frame> frames;

  [[nodiscard]] std::string text() const
  {
    return std::to_string(landmarks) + " landmarks, " + std::to_string(detections) + " detections, " +
           (named ? "named, " : "anonymous, ") + (bearings ? (ranges ? "bearing and range" : "bearing") : "range") +
           (limited ? ", range limit" : "") + (right ? ", right map" : ", wrong map") + (standing ? ", standing" : "");
  }
};

namespace random_frames
{
inline LandmarkTable someMap(int count, double side, RandomStream& random)
{
  std::vector<Landmark> landmarks(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    landmarks[static_cast<std::size_t>(i)] = {.id = i,
                                              .position = {random.uniform(0, side), random.uniform(0, side), 0}};
  return LandmarkTable(std::move(landmarks));
}

/// Number from 1 to `most`, each order of magnitude as likely.
inline int anyNumber(int most, RandomStream& random)
{
  return static_cast<int>(std::exp(random.uniform(0, std::log(most + 0.999))));
}

inline Detection detectionOf(const RandomFrames& scene, const Landmark& landmark, const Pose2& robot,
                             RandomStream& random)
{
  const Vector2d position = landmark.position.head<2>();
  Detection d{.id = scene.named ? landmark.id : kNoId, .std_bearing = degToRad(0.2), .std_range = 0.03};
  const double bearing_noise = random.gaussian(), range_noise = random.gaussian();
  if (scene.bearings) d.bearing = wrap(predictBearing(robot, position) + d.std_bearing * bearing_noise);
  if (scene.ranges) d.range = std::abs(predictRange(robot, position) + d.std_range * range_noise);
  return d;
}

/// What the sensor reports in the world that it is in: landmarks in view again and again, one in ten false.
inline Reading readingAt(const RandomFrames& scene, const LandmarkTable& world, const Pose2& robot, double side,
                         RandomStream& random)
{
  constexpr double kRange = 10, kClutter = 0.1;
  Reading reading{.sensor = "sensor"};
  if (scene.limited) reading.model.max_range = kRange;
  reading.model.clutter_probability = kClutter;
  std::vector<std::size_t> in_view;
  for (std::size_t j = 0; j < world.size(); ++j)
    if (!scene.limited || (world[j].position.head<2>() - robot.position()).norm() < kRange) in_view.push_back(j);
  for (int d = 0; d < scene.detections; ++d)
  {
    Landmark seen{.id = static_cast<int>(random.below(world.size())),
                  .position = {random.uniform(0, side), random.uniform(0, side), 0}};
    if (!in_view.empty() && !random.chance(kClutter)) seen = world[in_view[random.below(in_view.size())]];
    reading.detections.push_back(detectionOf(scene, seen, robot, random));
  }
  return reading;
}
}  // namespace random_frames

/// Map and `count` frames, one per second, for a scene whose properties are set.
inline void fillFrames(RandomFrames& scene, std::size_t count, RandomStream& random)
{
  const double side = std::sqrt(10.0 * scene.landmarks) + 1;
  scene.map = random_frames::someMap(scene.landmarks, side, random);
  scene.region = {{0, 0}, {side, side}};
  const LandmarkTable world = scene.right ? scene.map : random_frames::someMap(scene.landmarks, side, random);
  Pose2 robot{random.uniform(0, side), random.uniform(0, side), random.uniform(-kPi, kPi)};
  for (std::size_t k = 0; k < count; ++k)
  {
    const Pose2 step = k == 0 || scene.standing ? Pose2{} : Pose2{0.2, 0, 0.1};
    robot = compose(robot, step);
    Frame frame{.time = static_cast<double>(k)};
    frame.motion = {step, step.position().norm(), std::abs(step.phi), k == 0 ? 0.0 : 1.0};
    frame.readings.push_back(random_frames::readingAt(scene, world, robot, side, random));
    frame.readings.back().time = frame.time;
    scene.frames.push_back(std::move(frame));
  }
}

/// Up to `most_landmarks` and `most_detections`; `count` frames, one per second.
inline RandomFrames randomFrames(int most_landmarks, int most_detections, std::size_t count, RandomStream& random)
{
  RandomFrames scene;
  scene.landmarks = random_frames::anyNumber(most_landmarks, random);
  scene.detections = random_frames::anyNumber(most_detections, random);
  scene.named = random.chance(0.3);
  scene.right = random.chance(0.5);
  scene.limited = random.chance(0.5);
  scene.standing = random.chance(0.3);
  const std::size_t kind = random.below(3);
  scene.bearings = kind != 1;
  scene.ranges = kind != 0;
  fillFrames(scene, count, random);
  return scene;
}
}  // namespace mrpt_ext
