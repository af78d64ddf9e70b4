#pragma once

#include <benchmark/benchmark.h>

#include "random_scene.h"

namespace mrpt_ext
{
/// Exact bearings of one random scene in a square of 10 m, as angles and as unit vectors.
struct SightedScene
{
  Scene scene;
  std::vector<double> bearings;
  std::vector<Vector2d> units;
};

inline constexpr std::size_t kProblems = 4096;

/// The same problems for every variant.
inline std::vector<SightedScene> sightedScenes(int landmarks)
{
  RandomStream random(7);
  std::vector<SightedScene> all(kProblems);
  for (SightedScene& s : all)
  {
    s.scene = randomScene(random, landmarks);
    for (const Vector2d& l : s.scene.landmarks)
    {
      s.bearings.push_back(predictBearing(s.scene.robot, l));
      s.units.emplace_back(std::cos(s.bearings.back()), std::sin(s.bearings.back()));
    }
  }
  return all;
}

/// Counter time_per_item [s]; with `count` problems in each iteration.
inline void reportPerItem(benchmark::State& state, std::size_t count)
{
  state.counters["time_per_item"] = benchmark::Counter(
      static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
}  // namespace mrpt_ext
