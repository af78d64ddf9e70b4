#pragma once

#include <vector>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/solvers/known_bearing.h"

namespace mrpt_ext
{
/// Landmarks and a robot, uniform in a square of 10 m.
struct Scene
{
  std::vector<Vector2d> landmarks;
  Pose2 robot;
};

inline Scene randomScene(RandomStream& random, int landmark_count)
{
  Scene scene;
  for (int i = 0; i < landmark_count; ++i) scene.landmarks.emplace_back(random.uniform(0, 10), random.uniform(0, 10));
  scene.robot = {random.uniform(0, 10), random.uniform(0, 10), random.uniform(-kPi, kPi)};
  return scene;
}

/// Bearings of all landmarks, with Gaussian noise.
inline std::vector<KnownBearing> measureBearings(const Scene& scene, RandomStream& random, double noise, double std)
{
  std::vector<KnownBearing> bearings;
  for (const Vector2d& l : scene.landmarks)
    bearings.push_back({l, wrap(predictBearing(scene.robot, l) + noise * random.gaussian()), std});
  return bearings;
}
}  // namespace mrpt_ext
