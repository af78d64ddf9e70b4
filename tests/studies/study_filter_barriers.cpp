#include <cmath>
#include <iomanip>

#include "filter_scenario.h"
#include "mrpt_ext/evaluation/consistency.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr double kWrong = 0.5;  // [m]

struct Outcome
{
  std::size_t steps = 0, ok = 0, inside = 0, wrong = 0, wrong_runs = 0, found = 0;
  double squared = 0;
};

void runOne(const std::vector<std::string>& simulator, const std::vector<std::string>& localization, std::uint64_t seed,
            std::ostream& out, Outcome& outcome)
{
  const FilterScenario scenario = playScenario("barriers", seed, simulator, localization);
  std::size_t wrong = 0;
  bool found = false;
  for (const FilterSample& sample : runFilter(scenario, seed))
  {
    ++outcome.steps;
    found = sample.step.verdict == Verdict::ok && sample.distance() < kWrong;
    if (sample.step.verdict != Verdict::ok) continue;
    ++outcome.ok;
    outcome.inside += sample.positionNees() < chiSquareQuantile(2, 0.95) ? 1 : 0;
    wrong += sample.distance() > kWrong ? 1 : 0;
    if (sample.distance() < kWrong) outcome.squared += square(sample.distance());
  }
  outcome.wrong += wrong;
  outcome.wrong_runs += wrong > 0 ? 1 : 0;
  outcome.found += found ? 1 : 0;
  if (wrong > 0) out << "seed " << seed << ": " << wrong << " estimates ok but wrong\n" << std::flush;
}

void report(const std::string& name, const std::vector<std::string>& simulator,
            const std::vector<std::string>& localization, int runs, std::ostream& out)
{
  Outcome all;
  for (int i = 0; i < runs; ++i) runOne(simulator, localization, studySeed(i), out, all);
  const auto ok = static_cast<double>(std::max<std::size_t>(1, all.ok));
  out << std::fixed << std::setprecision(3) << "| " << name << " | " << runs << " | " << all.found << " | "
      << static_cast<double>(all.ok) / static_cast<double>(all.steps) << " | " << static_cast<double>(all.inside) / ok
      << " | " << all.wrong << " | " << all.wrong_runs << " | "
      << std::sqrt(all.squared / std::max(1.0, ok - static_cast<double>(all.wrong))) << " |\n"
      << std::flush;
}

void run(std::ostream& out)
{
  out << "Wrong: more than " << kWrong << " m off while the verdict is ok. Every run is another room.\n\n"
      << "| detections | runs | ok and right at the end | ok | in 95 % region | ok but wrong | runs with such | RMSE "
         "[m] |\n|---|---|---|---|---|---|---|---|\n";
  const int runs = studyRuns(1000);
  report("range and bearing", {}, {}, runs, out);
  report("bearings", {"Sensor_laser.kind=bearings"}, {}, std::max(1, runs / 4), out);
  report("clutter not declared", {}, {"Sensor_laser.clutter_probability=0.05"}, std::max(1, runs / 4), out);
}

const RegisterStudy kStudy("filter_barriers",
                           "Rows of posts that look like landmarks and hide others: is the verdict ever ok and wrong?",
                           run);
}  // namespace
}  // namespace mrpt_ext
