#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// A scan of anonymous detections in a square map of uniformly distributed landmarks.
struct SearchSceneOptions
{
  int landmarks = 1000;
  double area_per_landmark = 10;        ///< [m^2]
  int categories = 1;                   ///< the landmarks fall evenly into categories, which detections report
  std::optional<double> max_range = 8;  ///< [m]; absent: every landmark is in view
  double border = 8;                    ///< the robot stays this far from the border of the map [m]
  double detection_probability = 0.7;
  std::optional<int> seen;      ///< instead: exactly so many, randomly chosen of those in view
  double false_detections = 1;  ///< mean number
  bool random_false = false;    ///< their number varies (Poisson); otherwise it is the mean, rounded
  bool with_bearing = true;
  bool with_range = false;
  double std_bearing = degToRad(0.1);  ///< [rad]
  double std_range = 0.03;             ///< [m]
};

struct SceneMap
{
  double side = 0;  ///< [m]; the map spans [0, side]^2
  LandmarkTable landmarks;

  [[nodiscard]] LandmarkIndex index() const { return LandmarkIndex(landmarks); }
};

inline SceneMap randomMap(const SearchSceneOptions& options, RandomStream& random)
{
  SceneMap map;
  map.side = std::sqrt(options.area_per_landmark * options.landmarks);
  std::vector<Landmark> landmarks(static_cast<std::size_t>(options.landmarks));
  for (int i = 0; i < options.landmarks; ++i)
  {
    Landmark& landmark = landmarks[static_cast<std::size_t>(i)];
    landmark.id = i;
    landmark.position = {random.uniform(0, map.side), random.uniform(0, map.side), 0};
    if (options.categories > 1) landmark.category = "category" + std::to_string(i % options.categories);
  }
  map.landmarks = LandmarkTable(std::move(landmarks));
  return map;
}

/// A scan and its ground truth.
struct SceneScan
{
  Scan scan;
  Pose2 robot;             ///< truth
  std::vector<int> truth;  ///< landmark of each detection; -1: false
};

/// Measures a point `offset` away from the sensor (sensor axes), with noise.
inline AnonymousDetection measurePoint(const Vector2d& offset, const SearchSceneOptions& options, RandomStream& random)
{
  AnonymousDetection d;
  d.std_bearing = options.std_bearing;
  d.std_range = options.std_range;
  const double bearing_noise = random.gaussian(), range_noise = random.gaussian();
  if (options.with_bearing) d.bearing = wrap(std::atan2(offset.y(), offset.x()) + d.std_bearing * bearing_noise);
  if (options.with_range) d.range = std::abs(offset.norm() + d.std_range * range_noise);
  return d;
}

/// The sensor model that a configuration would declare.
inline SensorModel declaredModel(const SearchSceneOptions& options)
{
  SensorModel model;
  model.max_range = options.max_range;
  const double in_view =
      options.max_range ? kPi * square(*options.max_range) / options.area_per_landmark : options.landmarks;
  const double seen = options.seen ? *options.seen : options.detection_probability * in_view;
  model.detection_probability = std::min(seen / in_view, 0.99);
  model.clutter_probability = options.false_detections / std::max(1.0, options.false_detections + seen);
  return model;
}

/// A simulated scan from `robot` by a sensor at `T_robot_sensor`; its detections are in random order.
inline SceneScan observe(const SceneMap& map, const LandmarkIndex& index, const SearchSceneOptions& options,
                         const Pose2& robot, RandomStream& random, const Pose2& T_robot_sensor = {})
{
  SceneScan view;
  view.robot = robot;
  view.scan.T_robot_sensor = T_robot_sensor;
  const Pose2 world_in_sensor = inverse(compose(robot, T_robot_sensor));
  const double radius = options.max_range.value_or(2 * map.side);

  std::vector<int> in_view;
  index.forEachNear(compose(robot, T_robot_sensor).position(), radius,
                    [&](std::size_t l) { in_view.push_back(static_cast<int>(l)); });
  const auto shuffle = [&random](std::vector<int>& list)
  {
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
  };
  shuffle(in_view);
  if (options.seen) in_view.resize(std::min(in_view.size(), static_cast<std::size_t>(*options.seen)));
  std::vector<int> sources;
  for (const int l : in_view)
    if (options.seen || random.chance(options.detection_probability)) sources.push_back(l);
  const int wrong = options.random_false ? random.poisson(options.false_detections)
                                         : static_cast<int>(std::lround(options.false_detections));
  sources.insert(sources.end(), static_cast<std::size_t>(wrong), -1);
  shuffle(sources);

  for (const int l : sources)
  {
    if (l >= 0)
    {
      const auto landmark = static_cast<std::size_t>(l);
      AnonymousDetection d = measurePoint(transform(world_in_sensor, index.position(landmark)), options, random);
      if (options.categories > 1) d.category = index.category(landmark);
      view.scan.detections.push_back(d);
    }
    else
    {
      const double distance = std::min(radius, map.side) * random.uniform();  // uniform in range, as models assume
      const double direction = random.uniform(-kPi, kPi);
      const Vector2d offset(distance * std::cos(direction), distance * std::sin(direction));
      AnonymousDetection d = measurePoint(offset, options, random);
      if (options.categories > 1) d.category = index.category(random.below(index.size()));
      view.scan.detections.push_back(d);
    }
    view.truth.push_back(l);
  }
  view.scan.model = declaredModel(options);
  return view;
}

/// The same at a random pose, away from the border.
inline SceneScan observeSomewhere(const SceneMap& map, const LandmarkIndex& index, const SearchSceneOptions& options,
                                  RandomStream& random)
{
  const double border = std::min(options.border, 0.45 * map.side);
  const double x = random.uniform(border, map.side - border), y = random.uniform(border, map.side - border);
  return observe(map, index, options, {x, y, random.uniform(-kPi, kPi)}, random);
}

/// Within 0.1 m and 1 deg of the truth.
inline bool isAtTruth(const Pose2& pose, const Pose2& truth)
{
  return (pose.position() - truth.position()).norm() <= 0.1 && std::abs(wrap(pose.phi - truth.phi)) <= degToRad(1);
}
}  // namespace mrpt_ext
