#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "filter_scenario.h"
#include "mrpt_ext/evaluation/consistency.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kFarOff = 0.5;            // [m]
constexpr double kFarOffDeviations = 4;    // stated standard deviations, beside that
constexpr double kFoundAgainWithin = 1.0;  // [m]
constexpr double kEnd = 30;                // [s] of the end of a run, in which a filter that is found is near once

struct OdometryTally
{
  std::size_t runs = 0, lost_for_good = 0, wrong_runs = 0, steps = 0, ok = 0, wrong = 0, inside = 0, inside_heading = 0;
  double squared = 0;
};

bool isWrong(const FilterSample& sample)
{
  return sample.distance() > kFarOff && sample.positionNees() > square(kFarOffDeviations);
}

/// What is told of a single run.
struct RunOutcome
{
  bool lost_for_good = false;
  std::size_t frames_at_end = 0;  ///< with landmarks in view
  std::size_t wrong = 0;          ///< estimates
  double first_wrong = 0;         ///< [s]
  double farthest = 0;            ///< error of a wrong one [m]
};

RunOutcome addRun(const std::vector<FilterSample>& samples, OdometryTally& tally)
{
  ++tally.runs;
  RunOutcome outcome{.lost_for_good = true};
  for (const FilterSample& sample : samples)
  {
    ++tally.steps;
    const bool at_end = sample.time > samples.back().time - kEnd;
    outcome.frames_at_end += at_end ? 1 : 0;
    if (at_end && sample.distance() < kFoundAgainWithin) outcome.lost_for_good = false;
    if (sample.step.verdict != Verdict::ok) continue;
    ++tally.ok;
    tally.squared += square(sample.distance());
    tally.inside += sample.positionNees() < chiSquareQuantile(2, 0.95) ? 1 : 0;
    tally.inside_heading +=
        square(sample.error.z()) < chiSquareQuantile(1, 0.95) * sample.best().pose.covariance(2, 2) ? 1 : 0;
    if (!isWrong(sample)) continue;
    if (outcome.wrong++ == 0) outcome.first_wrong = sample.time;
    outcome.farthest = std::max(outcome.farthest, sample.distance());
  }
  tally.lost_for_good += outcome.lost_for_good ? 1 : 0;
  tally.wrong_runs += outcome.wrong > 0 ? 1 : 0;
  tally.wrong += outcome.wrong;
  return outcome;
}

void printRow(std::ostream& out, const std::string& name, const OdometryTally& tally)
{
  const auto share = [](std::size_t part, std::size_t whole)
  { return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, whole)); };
  out << "| " << name << " | " << tally.runs << " | " << tally.lost_for_good << std::fixed << std::setprecision(3)
      << " | " << share(tally.ok, tally.steps) << " | " << tally.wrong_runs << " | " << tally.wrong << " of "
      << tally.ok << " | " << share(tally.inside, tally.ok) << " | " << share(tally.inside_heading, tally.ok) << " | "
      << std::sqrt(tally.squared / static_cast<double>(std::max<std::size_t>(1, tally.ok))) << " |\n"
      << std::flush;
}

void runBadOdometry(std::ostream& out)
{
  const int runs = studyRuns(200);
  out << "Lost for good: never within " << kFoundAgainWithin << " m in the last " << kEnd << " s. Wrong: ok, more than "
      << kFarOff << " m and " << kFarOffDeviations << " stated deviations off.\n\n"
      << "| detections, seeds | runs | lost for good | ok | runs with ok but wrong | ok but wrong | truth in 95 % "
         "region "
         "of the position | of the heading | RMSE when ok [m] |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const std::string identity : {"known", "anonymous"})
  {
    OdometryTally even, odd;
    std::ostringstream remarks;
    for (int k = 0; k < runs; ++k)
    {
      const std::uint64_t seed = studySeed(k);
      const FilterScenario scenario = playScenario("bad-odometry", seed, {"Sensor_camera.identity=" + identity});
      const RunOutcome outcome = addRun(runFilter(scenario, seed), seed % 2 == 0 ? even : odd);
      if (outcome.wrong > 0)
        remarks << "| seed " << seed << ": wrong in " << outcome.wrong << " estimates from " << outcome.first_wrong
                << " s on, at most " << outcome.farthest << " m off |\n";
      if (outcome.lost_for_good)
        remarks << "| seed " << seed << ": lost, with landmarks in view in " << outcome.frames_at_end
                << " frames of the end |\n";
    }
    printRow(out, identity + ", even", even);
    printRow(out, identity + ", odd", odd);
    out << remarks.str();
  }
}

const RegisterStudy kBadOdometryStudy("filter_bad_odometry",
                                      "Odometry worse than stated: is the filter found again, and honest about it?",
                                      runBadOdometry);
}  // namespace
}  // namespace mrpt_ext
