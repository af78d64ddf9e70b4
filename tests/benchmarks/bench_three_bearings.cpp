#include <benchmark/benchmark.h>

#include "mrpt_ext/solvers/bearing_triple.h"

namespace mrpt_ext
{
namespace
{
void threeBearings(benchmark::State& state)
{
  const std::array<Vector2d, 3> landmarks{Vector2d(0, 0), Vector2d(4, 0), Vector2d(1, 3)};
  const std::array<Vector2d, 3> units{Vector2d(0.6, 0.8), Vector2d(0.8, -0.6), Vector2d(-0.6, 0.8)};
  for (auto _ : state) benchmark::DoNotOptimize(solveBearingTriple(landmarks, units, 0));
}
BENCHMARK(threeBearings)->Name("hypothesis/three_bearings/ours");
}  // namespace
}  // namespace mrpt_ext
