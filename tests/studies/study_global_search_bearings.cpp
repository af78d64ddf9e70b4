#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
struct Outcome
{
  bool found = false, first = false, unique = false, finished = true;
  double poses = 0, milliseconds = 0;
};

/// Milliseconds of processor time: other programs may run meanwhile.
double processorTime() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Outcome searchOnce(const BearingSearch& search, const SceneScan& view, const PoseSearchOptions& how)
{
  const double start = processorTime();
  const PoseSearchResult result = search.search({&view.scan, 1}, how);
  Outcome o;
  o.milliseconds = processorTime() - start;
  o.found = std::any_of(result.poses.begin(), result.poses.end(),
                        [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, view.robot); });
  o.poses = static_cast<double>(result.poses.size());
  o.unique = result.unique;
  o.finished = result.finished;
  if (result.poses.empty()) return o;
  o.first = isAtTruth(result.poses.front().pose.mean, view.robot);
  return o;
}

/// A new map for every hundred trials.
std::vector<Outcome> searchMany(const SearchSceneOptions& options, int trials, std::uint64_t seed)
{
  std::vector<Outcome> outcomes;
  for (std::uint64_t m = 0; static_cast<int>(outcomes.size()) < trials; ++m)
  {
    RandomStream random(seed, m);
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    const BearingSearch search(index);
    PoseSearchOptions how;
    if (!options.max_range) how.area = Box2{Vector2d::Zero(), Vector2d::Constant(map.side)};
    for (int t = 0; t < 100 && static_cast<int>(outcomes.size()) < trials; ++t)
      outcomes.push_back(searchOnce(search, observeSomewhere(map, index, options, random), how));
  }
  return outcomes;
}

void tabulateRecall(std::ostream& out)
{
  struct Row
  {
    std::string name;
    SearchSceneOptions options;
    int trials;
  };
  std::vector<Row> rows;
  const auto add = [&](std::string name, int trials, auto&& change)
  {
    rows.push_back({std::move(name), {}, trials});
    change(rows.back().options);
  };
  add("1 000 landmarks, 0.1 deg", 1000, [](SearchSceneOptions&) {});
  add("10 000 landmarks, 0.1 deg", 100, [](SearchSceneOptions& o) { o.landmarks = 10000; });
  add("1 000, three false of about 16", 200,
      [](SearchSceneOptions& o)
      {
        o.false_detections = 3;
        o.seen = 13;
      });
  add("1 000, four kinds", 1000, [](SearchSceneOptions& o) { o.categories = 4; });
  add("200, no range limit, 20 seen, 0.03 deg", 100,
      [](SearchSceneOptions& o)
      {
        o.landmarks = 200;
        o.max_range.reset();
        o.seen = 20;
        o.std_bearing = degToRad(0.03);
      });
  add("1 000, 0.3 deg", 300, [](SearchSceneOptions& o) { o.std_bearing = degToRad(0.3); });
  add("100 000 landmarks, 0.1 deg", 20, [](SearchSceneOptions& o) { o.landmarks = 100000; });
  out << "One landmark per 10 m2, detected within 8 m with probability 0.7, one false detection; right: within 0.1 m "
         "and 1 "
         "deg; times of the processor.\n\n"
         "| scene | trials | true pose returned | first | called unique | wrong among these | poses | ms median | ms "
         "90 "
         "% | "
         "unfinished |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows)
  {
    const std::vector<Outcome> outcomes = searchMany(row.options, row.trials, 7);
    const auto count = [&](auto&& property) { return std::count_if(outcomes.begin(), outcomes.end(), property); };
    std::vector<double> times;
    double poses = 0;
    for (const Outcome& o : outcomes)
    {
      times.push_back(o.milliseconds);
      poses += o.poses / static_cast<double>(outcomes.size());
    }
    std::sort(times.begin(), times.end());
    out << "| " << row.name << " | " << outcomes.size() << " | " << count([](const Outcome& o) { return o.found; })
        << " | " << count([](const Outcome& o) { return o.first; }) << " | "
        << count([](const Outcome& o) { return o.unique; }) << " | "
        << count([](const Outcome& o) { return o.unique && !o.first; }) << " | " << std::setprecision(3) << poses
        << " | " << times[times.size() / 2] << " | " << times[times.size() * 9 / 10] << " | "
        << count([](const Outcome& o) { return !o.finished; }) << " |" << std::endl;
  }
}

const RegisterStudy kRecall("global_search_bearings",
                            "Global localization from anonymous bearings: how often right, how often unique, how fast?",
                            tabulateRecall);
}  // namespace
}  // namespace mrpt_ext
