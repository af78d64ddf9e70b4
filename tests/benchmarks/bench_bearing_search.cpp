#include <benchmark/benchmark.h>

#include <chrono>

#include "global_search_scene.h"
#include "limit/plain_bearing_search.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"

namespace mrpt_ext
{
namespace
{
/// One map, and robots lost in it.
struct LostRobots
{
  SceneMap map;
  LandmarkIndex index;
  std::vector<SceneScan> views;

  LostRobots(const SearchSceneOptions& options, int count) : LostRobots(options, count, RandomStream(2026)) {}

 private:
  LostRobots(const SearchSceneOptions& options, int count, RandomStream random)
      : map(randomMap(options, random)), index(map.index())
  {
    for (int i = 0; i < count; ++i) views.push_back(observeSomewhere(map, index, options, random));
  }
};

/// Each iteration is one search; the tables that a first search builds for all later ones are built beforehand and
/// timed as `first_s`.
void findLost(benchmark::State& state, const SearchSceneOptions& options, int count)
{
  const LostRobots lost(options, count);
  const BearingSearch search(lost.index);
  PoseSearchOptions search_options;
  search_options.area = Box2{{0, 0}, {lost.map.side, lost.map.side}};
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(search.search({&lost.views.front().scan, 1}, search_options));
  state.counters["first_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  double found = 0, poses = 0;
  std::size_t next = 0;
  for (auto _ : state)
  {
    const SceneScan& view = lost.views[next++ % lost.views.size()];
    const PoseSearchResult result = search.search({&view.scan, 1}, search_options);
    found += std::any_of(result.poses.begin(), result.poses.end(),
                         [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, view.robot); });
    poses += static_cast<double>(result.poses.size());
  }
  state.counters["recall"] = found / static_cast<double>(state.iterations());
  state.counters["poses"] = poses / static_cast<double>(state.iterations());
}

SearchSceneOptions withLandmarks(int count)
{
  SearchSceneOptions options;
  options.landmarks = count;
  return options;
}

SearchSceneOptions threeFalseOfSixteen()
{
  SearchSceneOptions options;
  options.false_detections = 3;
  options.seen = 13;
  return options;
}

SearchSceneOptions fourKinds()
{
  SearchSceneOptions options;
  options.categories = 4;
  return options;
}

SearchSceneOptions unlimited()
{
  SearchSceneOptions options = withLandmarks(200);
  options.max_range.reset();
  options.seen = 20;
  options.false_detections = 0;
  options.std_bearing = degToRad(0.03);
  return options;
}

BENCHMARK_CAPTURE(findLost, thousand, withLandmarks(1000), 100)
    ->Name("search/bearings_1000/ours")
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findLost, ten_thousand, withLandmarks(10000), 10)
    ->Name("search/bearings_10000/ours")
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findLost, hundred_thousand, withLandmarks(100000), 2)
    ->Name("search/bearings_100000/ours")
    ->Iterations(2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findLost, three_false, threeFalseOfSixteen(), 50)
    ->Name("search/bearings_1000_three_false/ours")
    ->Iterations(50)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findLost, four_kinds, fourKinds(), 200)
    ->Name("search/bearings_1000_four_kinds/ours")
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(findLost, no_range_limit, unlimited(), 20)
    ->Name("search/bearings_200_unlimited/ours")
    ->Iterations(20)
    ->Unit(benchmark::kMillisecond);

void findLostPlainly(benchmark::State& state)
{
  const LostRobots lost(withLandmarks(1000), 100);
  double found = 0;
  std::size_t next = 0;
  for (auto _ : state)
  {
    const SceneScan& view = lost.views[next++ % lost.views.size()];
    const auto pose = plain::searchBearings(lost.index, view.scan);
    found += pose && (pose->position() - view.robot.position()).norm() < 0.5;  // it does not refine
  }
  state.counters["recall"] = found / static_cast<double>(state.iterations());
}
BENCHMARK(findLostPlainly)->Name("search/bearings_1000/plain")->Iterations(20)->Unit(benchmark::kMillisecond);
}  // namespace
}  // namespace mrpt_ext
