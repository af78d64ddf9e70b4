#include <algorithm>
#include <ctime>
#include <iomanip>

#include "global_search_scene.h"
#include "mrpt_ext/correspondence/points/point_search.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
/// Seconds of processor time: other programs may run meanwhile.
double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void tabulate(std::ostream& out, int landmarks, double std_bearing_deg, int trials)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.with_range = true;
  options.std_bearing = degToRad(std_bearing_deg);
  RandomStream random(11, static_cast<std::uint64_t>(landmarks));
  const SceneMap map = randomMap(options, random);
  const LandmarkIndex index = map.index();
  const double before = processorTime();
  const PointSearch search(index);
  const double build = processorTime() - before;
  int found = 0, first = 0, unique = 0, wrong = 0;
  double returned = 0;
  std::vector<double> ms;
  for (int t = 0; t < trials; ++t)
  {
    const SceneScan view = observeSomewhere(map, index, options, random);
    const double start = processorTime();
    const PoseSearchResult result = search.search({&view.scan, 1});
    ms.push_back(1000 * (processorTime() - start));
    const auto right = [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, view.robot); };
    const bool best = !result.poses.empty() && right(result.poses.front());
    found += std::any_of(result.poses.begin(), result.poses.end(), right);
    first += best;
    unique += result.unique;
    wrong += result.unique && !best;
    returned += static_cast<double>(result.poses.size()) / trials;
  }
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double share) { return ms[static_cast<std::size_t>(share * (trials - 1))]; };
  out << "| " << landmarks << " | " << std_bearing_deg << " | " << trials << " | " << std::fixed << std::setprecision(1)
      << 100.0 * found / trials << " % | " << 100.0 * first / trials << " % | " << 100.0 * unique / trials << " % | "
      << wrong << " | " << std::setprecision(2) << returned << " | " << std::setprecision(3) << at(0.5) << " | "
      << at(0.95) << " | " << std::setprecision(1) << static_cast<double>(search.index().bytes()) / 1e6 << " | "
      << std::setprecision(2) << build << " |\n"
      << std::defaultfloat << std::flush;
}

void run(std::ostream& out)
{
  out << "Standard deviation of ranges 0.03 m, one landmark per 10 m2, detected within 8 m with probability 0.7, one "
         "false detection; "
         "right: within 0.1 m and 1 deg.\n\n"
         "| landmarks | sigma of bearings [deg] | trials | right pose returned | first | called unique | of these "
         "wrong "
         "| returned | median [ms] | 95 % [ms] | index [MB] | built in [s] |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const double std_bearing_deg : {0.1, 0.3, 1.0})
    for (const int landmarks : {100, 1000, 10000, 100000}) tabulate(out, landmarks, std_bearing_deg, 1000);
}

const RegisterStudy kStudy("global_search_points",
                           "Global localization from anonymous ranges and bearings: how often right, how fast?", run);
}  // namespace
}  // namespace mrpt_ext
