#include <benchmark/benchmark.h>

#include "limit/plain_tree.h"
#include "mrpt_ext/correspondence/interpretation_tree.h"
#include "random_scene.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = degToRad(0.5);
constexpr std::size_t kScenes = 64;

struct TreeScene
{
  Scene scene;
  std::vector<double> bearings;
};

/// Exact bearings to the first landmarks, everything random in a square of 10 m; the same for every variant.
std::vector<TreeScene> treeScenes(int landmarks, std::size_t seen)
{
  RandomStream random(12);
  std::vector<TreeScene> scenes;
  while (scenes.size() < kScenes)
  {
    TreeScene s{randomScene(random, landmarks), {}};
    for (std::size_t k = 0; k < seen; ++k) s.bearings.push_back(predictBearing(s.scene.robot, s.scene.landmarks[k]));
    scenes.push_back(std::move(s));
  }
  return scenes;
}

/// One scene per iteration, in turn; the time is the mean over the scenes.
template <class Search>
void overScenes(benchmark::State& state, int landmarks, const Search& search)
{
  const std::vector<TreeScene> scenes = treeScenes(landmarks, 7);
  std::size_t turn = 0;
  double solutions = 0;
  for (auto _ : state) solutions += static_cast<double>(search(scenes[turn++ % kScenes]));
  state.counters["solutions"] = solutions / static_cast<double>(turn);
}

std::size_t searchOurs(const TreeScene& s)
{
  std::vector<UnidentifiedBearing> bearings;
  for (const double b : s.bearings) bearings.push_back({b, {}});
  InterpretationOptions options;
  options.max_residual = kGate;
  options.area = MapArea{{0, 0}, {10, 10}};
  return interpretBearings(s.scene.landmarks, bearings, options).solutions.size();
}

std::size_t searchPlain(const TreeScene& s)
{
  std::vector<PlainTree::Point> landmarks;
  for (const Vector2d& l : s.scene.landmarks) landmarks.push_back({l.x(), l.y()});
  return static_cast<std::size_t>(PlainTree(std::move(landmarks), s.bearings, kGate).search());
}

void tree12Ours(benchmark::State& state) { overScenes(state, 12, searchOurs); }
void tree12Plain(benchmark::State& state) { overScenes(state, 12, searchPlain); }
void tree30Ours(benchmark::State& state) { overScenes(state, 30, searchOurs); }
void tree30Plain(benchmark::State& state) { overScenes(state, 30, searchPlain); }

BENCHMARK(tree12Ours)->Name("search/tree_12x7/ours")->Unit(benchmark::kMicrosecond);
BENCHMARK(tree12Plain)->Name("search/tree_12x7/plain")->Unit(benchmark::kMicrosecond);
BENCHMARK(tree30Ours)->Name("search/tree_30x7/ours")->Unit(benchmark::kMicrosecond);
BENCHMARK(tree30Plain)->Name("search/tree_30x7/plain")->Unit(benchmark::kMicrosecond);
}  // namespace
}  // namespace mrpt_ext
