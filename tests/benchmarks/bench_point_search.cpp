#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "global_search_scene.h"
#include "limit/plain_triangle_hash.h"
#include "mrpt_ext/correspondence/points/point_search.h"

namespace mrpt_ext
{
namespace
{
constexpr int kViews = 100;

SearchSceneOptions sceneOf(int landmarks)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.with_range = true;
  return options;
}

struct LostRobots
{
  explicit LostRobots(int landmarks) : options(sceneOf(landmarks))
  {
    RandomStream random(2026);
    map = randomMap(options, random);
    index.emplace(map.index());
    for (int i = 0; i < kViews; ++i) views.push_back(observeSomewhere(map, *index, options, random));
  }
  SearchSceneOptions options;
  SceneMap map;
  std::optional<LandmarkIndex> index;
  std::vector<SceneScan> views;
};

void ours(benchmark::State& state)
{
  const LostRobots lost(static_cast<int>(state.range(0)));
  const auto before = std::chrono::steady_clock::now();
  const PointSearch search(*lost.index);
  state.counters["build_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  state.counters["index_mb"] = static_cast<double>(search.index().bytes()) / 1e6;
  std::size_t next = 0;
  double found = 0;
  for (auto _ : state)
  {
    const SceneScan& view = lost.views[next++ % kViews];
    const PoseSearchResult result = search.search({&view.scan, 1});
    found += std::any_of(result.poses.begin(), result.poses.end(),
                         [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, view.robot); });
  }
  state.counters["recall"] = found / static_cast<double>(state.iterations());
}

void plain(benchmark::State& state)
{
  const LostRobots lost(static_cast<int>(state.range(0)));
  const PlainTriangleHash search(lost.index->positions(), lost.index->low(), 0.2);
  std::size_t next = 0;
  double found = 0;
  for (auto _ : state)
  {
    const SceneScan& view = lost.views[next++ % kViews];
    std::vector<Vector2d> points;
    for (const AnonymousDetection& d : view.scan.detections)
      points.emplace_back(*d.range * std::cos(*d.bearing), *d.range * std::sin(*d.bearing));
    const auto pose = search.find(points, 0.15);
    found += pose && isAtTruth(*pose, view.robot);
  }
  state.counters["recall"] = found / static_cast<double>(state.iterations());
}

BENCHMARK(ours)->Name("search/range_bearing_1000/ours")->Arg(1000)->Iterations(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(plain)->Name("search/range_bearing_1000/plain")->Arg(1000)->Iterations(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(ours)->Name("search/range_bearing_100000/ours")->Arg(100000)->Iterations(400)->Unit(benchmark::kMillisecond);
BENCHMARK(plain)
    ->Name("search/range_bearing_100000/plain")
    ->Arg(100000)
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace mrpt_ext
