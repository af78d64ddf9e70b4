#include <iomanip>

#include "mrpt_ext/correspondence/bearings/bearing_search.h"
#include "mrpt_ext/correspondence/points/point_search.h"
#include "probability_calibration.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
struct Tally
{
  ProbabilityCalibration mode, near;  ///< a hit: the truth's mode; within 0.1 m and 1 deg
  int trials = 0, unanswered = 0, unique = 0, unique_wrong = 0, unique_by_chance = 0;
};

/// A new map for every fifty trials.
template <typename Search>
void run(const SearchSceneOptions& options, int trials, std::uint64_t seed, Tally& tally)
{
  for (std::uint64_t m = 0; trials > 0; ++m)
  {
    RandomStream random(seed, m);
    const SceneMap map = randomMap(options, random);
    const LandmarkIndex index = map.index();
    const Search search(index);
    PoseSearchOptions how;
    how.area = Box2{Vector2d::Constant(options.border), Vector2d::Constant(map.side - options.border)};
    for (int t = 0; t < 50 && trials > 0; ++t, --trials)
    {
      const SceneScan view = observeSomewhere(map, index, options, random);
      const PoseSearchResult found = search.search({&view.scan, 1}, how);
      ++tally.trials;
      tally.unanswered += found.poses.empty();
      if (found.poses.empty()) continue;
      const ConsistentPose& best = found.poses.front();
      const bool hit = isTruthsMode(best, view);
      tally.mode.add(best.probability, hit);
      tally.near.add(best.probability, isAtTruth(best.pose.mean, view.robot));
      tally.unique += found.unique;
      tally.unique_wrong += found.unique && !hit;
      tally.unique_by_chance += found.unique && found.expected_false > 0.05;
    }
  }
}

const char* verdict(const ProbabilityCalibration::Bin& bin)
{
  if (!bin.isEnough()) return "too few";
  return bin.isInside() ? "yes" : "no";
}

void tabulate(std::ostream& out, const char* name, const Tally& tally)
{
  out << "\n"
      << name << ": " << tally.trials << " trials, " << tally.unanswered << " without a pose, " << tally.unique
      << " called unique, of these " << tally.unique_wrong << " wrong and " << tally.unique_by_chance
      << " with more than 0.05 false poses expected.\n\n"
         "| stated | trials | mean stated | truth's mode | in the 99 % interval | within 0.1 m, 1 deg | in the "
         "interval |\n"
         "|---|---|---|---|---|---|---|\n";
  for (std::size_t b = 0; b < tally.mode.bins.size(); ++b)
  {
    const ProbabilityCalibration::Bin &mode = tally.mode.bins[b], &near = tally.near.bins[b];
    out << "| " << 0.1 * static_cast<double>(b) << " .. " << 0.1 * static_cast<double>(b + 1) << " | " << mode.trials
        << " | " << std::setprecision(3) << mode.meanStated() << " | " << mode.hitRate() << " | " << verdict(mode)
        << " | " << near.hitRate() << " | " << verdict(near) << " |\n";
  }
}

SearchSceneOptions scene(int landmarks, double detection, double std_bearing_deg, int kinds = 1)
{
  SearchSceneOptions options;
  options.landmarks = landmarks;
  options.max_range = options.border = 6;
  options.random_false = true;
  options.detection_probability = detection;
  options.std_bearing = degToRad(std_bearing_deg);
  options.categories = kinds;
  return options;
}

void runBearings(std::ostream& out)
{
  Tally tally;
  run<BearingSearch>(scene(100, 0.6, 0.5), 500, 31, tally);
  run<BearingSearch>(scene(200, 0.45, 0.3), 500, 32, tally);
  run<BearingSearch>(scene(200, 0.4, 0.15), 400, 33, tally);
  run<BearingSearch>(scene(400, 0.5, 0.3), 200, 34, tally);
  run<BearingSearch>(scene(200, 0.35, 0.5, 2), 500, 35, tally);
  tabulate(out, "Bearings", tally);
}

void runPoints(std::ostream& out)
{
  Tally tally;
  std::uint64_t seed = 41;
  for (const double std_bearing_deg : {0.1, 0.5})
    for (const double detection : {0.2, 0.3})
      for (const int kinds : {1, 3})
      {
        SearchSceneOptions options = scene(300, detection, std_bearing_deg, kinds);
        options.with_range = true;
        run<PointSearch>(options, 500, seed++, tally);
      }
  tabulate(out, "Bearings with ranges", tally);
}

const RegisterStudy kBearings("pose_probability_bearings",
                              "Is the stated probability of the best pose right? (Bearings; random scenes.)",
                              runBearings);
const RegisterStudy kPoints("pose_probability_points",
                            "Is the stated probability of the best pose right? (Bearings with ranges.)", runPoints);
}  // namespace
}  // namespace mrpt_ext
