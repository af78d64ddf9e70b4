#include <benchmark/benchmark.h>

#include <algorithm>

#include "limit/plain_tree.h"
#include "mrpt_ext/correspondence/tree/interpretation_tree.h"
#include "random_scene.h"

namespace mrpt_ext
{
namespace
{
constexpr double kGate = degToRad(0.5);
constexpr std::size_t kScenes = 64, kSeen = 7;

struct TreeScene
{
  Scene scene;
  std::vector<double> bearings;  ///< to the landmarks of the same numbers, except for a false one at the end
  Box2 area;                     ///< of the robot; wider where the bearings err
};

/// What a search came to.
struct Found
{
  std::size_t solutions = 0;
  bool truth = false;
};

/// Bearings to the first landmarks, everything random in a square of 10 m; the same for every variant. The gate is 3.3
/// standard deviations of their errors, or they have none.
std::vector<TreeScene> treeScenes(int landmarks, bool noisy, std::size_t false_count)
{
  RandomStream random(12);
  std::vector<TreeScene> scenes;
  while (scenes.size() < kScenes)
  {
    const double margin = noisy ? 1 : 0;
    TreeScene s{randomScene(random, landmarks), {}, {{-margin, -margin}, {10 + margin, 10 + margin}}};
    for (std::size_t k = 0; k + false_count < kSeen; ++k)
      s.bearings.push_back(predictBearing(s.scene.robot, s.scene.landmarks[k]) +
                           (noisy ? kGate / 3.3 * random.gaussian() : 0));
    for (std::size_t k = 0; k < false_count; ++k) s.bearings.push_back(random.uniform(-kPi, kPi));
    scenes.push_back(std::move(s));
  }
  return scenes;
}

/// One scene per iteration, in turn; the time is the mean over the scenes.
template <class Search>
void overScenes(benchmark::State& state, int landmarks, bool noisy, std::size_t false_count, const Search& search)
{
  const std::vector<TreeScene> scenes = treeScenes(landmarks, noisy, false_count);
  std::size_t turn = 0;
  double solutions = 0, truths = 0;
  for (auto _ : state)
  {
    const Found found = search(scenes[turn++ % kScenes]);
    solutions += static_cast<double>(found.solutions);
    truths += found.truth ? 1 : 0;
  }
  state.counters["solutions"] = solutions / static_cast<double>(turn);
  state.counters["recall"] = truths / static_cast<double>(turn);
}

Found searchOurs(const TreeScene& s, InterpretationGate gate, std::size_t false_count)
{
  std::vector<AnonymousBearing> bearings;
  for (const double b : s.bearings) bearings.push_back({b, {}});
  InterpretationOptions options;
  options.gate = gate;
  options.max_residual = kGate;
  options.max_unmatched = static_cast<int>(false_count);
  options.area = s.area;
  const Interpretations found = interpretBearings(s.scene.landmarks, bearings, options);
  const auto is_truth = [&](const Interpretation& i)
  {
    bool in_order = true;
    for (std::size_t k = 0; k + false_count < kSeen; ++k) in_order = in_order && i.assignment[k] == static_cast<int>(k);
    return in_order;
  };
  return {found.solutions.size(), std::any_of(found.solutions.begin(), found.solutions.end(), is_truth)};
}

Found searchPlain(const TreeScene& s)
{
  std::vector<PlainTree::Point> landmarks;
  for (const Vector2d& l : s.scene.landmarks) landmarks.push_back({l.x(), l.y()});
  PlainTree tree(std::move(landmarks), s.bearings, kGate);
  const int solutions = tree.search();
  return {static_cast<std::size_t>(solutions), tree.foundInOrder()};
}

template <int kLandmarks, bool kNoisy, InterpretationGate kRule = InterpretationGate::worst_case,
          std::size_t kFalse = 0>
void ours(benchmark::State& state)
{
  overScenes(state, kLandmarks, kNoisy, kFalse, [](const TreeScene& s) { return searchOurs(s, kRule, kFalse); });
}

template <int kLandmarks, bool kNoisy>
void plain(benchmark::State& state)
{
  overScenes(state, kLandmarks, kNoisy, 0, searchPlain);
}

constexpr auto kCovariance = InterpretationGate::covariance;
constexpr auto kUnit = benchmark::kMicrosecond;
BENCHMARK(ours<12, false>)->Name("search/tree_12x7/ours")->Unit(kUnit);
BENCHMARK(ours<12, false, kCovariance>)->Name("search/tree_12x7/ours_covariance")->Unit(kUnit);
BENCHMARK(plain<12, false>)->Name("search/tree_12x7/plain")->Unit(kUnit);
BENCHMARK(ours<12, true>)->Name("search/tree_12x7_noisy/ours")->Unit(kUnit);
BENCHMARK(ours<12, true, kCovariance>)->Name("search/tree_12x7_noisy/ours_covariance")->Unit(kUnit);
BENCHMARK(plain<12, true>)->Name("search/tree_12x7_noisy/plain")->Unit(kUnit);
BENCHMARK(ours<12, true, InterpretationGate::worst_case, 1>)->Name("search/tree_12x7_one_false/ours")->Unit(kUnit);
BENCHMARK(ours<12, true, kCovariance, 1>)->Name("search/tree_12x7_one_false/ours_covariance")->Unit(kUnit);
BENCHMARK(ours<30, true>)->Name("search/tree_30x7/ours")->Unit(kUnit);
BENCHMARK(ours<30, true, kCovariance>)->Name("search/tree_30x7/ours_covariance")->Unit(kUnit);
BENCHMARK(plain<30, true>)->Name("search/tree_30x7/plain")->Unit(kUnit);
}  // namespace
}  // namespace mrpt_ext
