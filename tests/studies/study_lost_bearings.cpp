#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>

#include "lost_scene.h"
#include "mrpt_ext/correspondence/bearing_search.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
struct Outcome
{
  bool found = false, first = false, first_place = false, unique = false, finished = true;
  double poses = 0, probability = 0, milliseconds = 0;
};

/// With coarse bearings the right place may be known to worse than 0.1 m.
bool isWithinUncertainty(const ConsistentPose& p, const Pose2& truth)
{
  const double std = std::sqrt(p.pose.covariance.topLeftCorner<2, 2>().trace());
  return (p.pose.mean.position() - truth.position()).norm() <= std::min(4 * std, 1.0);
}

Outcome searchOnce(const BearingSearch& search, const LostView& view)
{
  const auto start = std::chrono::steady_clock::now();
  const PoseSearch result = search.search({&view.place, 1});
  Outcome o;
  o.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  o.found = std::any_of(result.poses.begin(), result.poses.end(),
                        [&](const ConsistentPose& p) { return isAtTruth(p.pose.mean, view.robot); });
  o.poses = static_cast<double>(result.poses.size());
  o.unique = result.unique;
  o.finished = result.finished;
  if (result.poses.empty()) return o;
  o.first = isAtTruth(result.poses.front().pose.mean, view.robot);
  o.first_place = o.first || isWithinUncertainty(result.poses.front(), view.robot);
  o.probability = result.poses.front().probability;
  return o;
}

/// A new map for every hundred trials.
std::vector<Outcome> searchMany(const LostSceneOptions& options, int trials, std::uint64_t seed)
{
  std::vector<Outcome> outcomes;
  for (std::uint64_t m = 0; static_cast<int>(outcomes.size()) < trials; ++m)
  {
    RandomStream random(seed, m);
    const LostMap map = strewLandmarks(options, random);
    const LandmarkIndex index = map.index();
    const BearingSearch search(index);
    for (int t = 0; t < 100 && static_cast<int>(outcomes.size()) < trials; ++t)
      outcomes.push_back(searchOnce(search, lookAroundSomewhere(map, index, options, random)));
  }
  return outcomes;
}

void tabulateRecall(std::ostream& out)
{
  struct Row
  {
    std::string name;
    LostSceneOptions options;
    int trials;
  };
  std::vector<Row> rows;
  const auto add = [&](std::string name, int trials, auto&& change)
  {
    rows.push_back({std::move(name), {}, trials});
    change(rows.back().options);
  };
  add("1 000 landmarks, 0.1 deg", 1000, [](LostSceneOptions&) {});
  add("10 000 landmarks, 0.1 deg", 100, [](LostSceneOptions& o) { o.landmarks = 10000; });
  add("100 000 landmarks, 0.1 deg", 20, [](LostSceneOptions& o) { o.landmarks = 100000; });
  add("1 000, three false of about 16", 200,
      [](LostSceneOptions& o)
      {
        o.false_readings = 3;
        o.seen = 13;
      });
  add("1 000, four kinds", 1000, [](LostSceneOptions& o) { o.kinds = 4; });
  add("1 000, 0.3 deg", 300, [](LostSceneOptions& o) { o.std_bearing = degToRad(0.3); });
  out << "| scene | trials | true pose returned | first | said unique | wrong among these | poses | ms median | ms 90 "
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

/// Probability of at least / at most `hits` successes, whichever is smaller.
double binomialTail(int trials, int hits, double p)
{
  double below = 0, at = 0;
  for (int k = 0; k <= hits; ++k)
  {
    at = std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) +
                  k * std::log(std::max(p, 1e-300)) + (trials - k) * std::log(std::max(1 - p, 1e-300)));
    below += at;
  }
  return std::min(below, 1 - below + at);
}

void tabulateCalibration(std::ostream& out)
{
  std::array<double, 10> stated{};
  std::array<int, 10> trials{}, hits{};
  for (const double sigma : {0.3, 0.6, 1.0})
    for (const double detection : {0.35, 0.5, 0.7})
    {
      LostSceneOptions options;
      options.landmarks = 200;
      options.max_range = 6;
      options.detection_probability = detection;
      options.std_bearing = degToRad(sigma);
      options.random_false = true;
      options.border = 6;
      for (const Outcome& o : searchMany(options, 40, 31))
      {
        if (o.poses == 0) continue;
        const auto bin = static_cast<std::size_t>(std::min(9.0, std::floor(10 * o.probability)));
        stated[bin] += o.probability;
        ++trials[bin];
        hits[bin] += o.first_place;
      }
    }
  out << "\n| stated probability of the best pose | trials | mean stated | hit rate | in the 99 % interval |\n"
         "|---|---|---|---|---|\n";
  for (std::size_t bin = 0; bin < stated.size(); ++bin)
  {
    if (trials[bin] == 0) continue;
    const double mean = stated[bin] / trials[bin];
    const bool enough = trials[bin] >= 30;
    const bool inside = binomialTail(trials[bin], hits[bin], mean) > 0.005;
    out << "| " << 0.1 * static_cast<double>(bin) << " .. " << 0.1 * static_cast<double>(bin + 1) << " | "
        << trials[bin] << " | " << std::setprecision(3) << mean << " | " << static_cast<double>(hits[bin]) / trials[bin]
        << " | " << (enough ? (inside ? "yes" : "no") : "too few") << " |\n";
  }
}

const RegisterStudy kRecall("lost_bearings", "How often, how fast and how surely is a lost robot found from bearings?",
                            tabulateRecall);
const RegisterStudy kCalibration(
    "lost_bearings_calibration",
    "Is the stated probability of the best pose right? (Hit: within 0.1 m and 1 deg, or 4 std and 1 m.)",
    tabulateCalibration);
}  // namespace
}  // namespace mrpt_ext
