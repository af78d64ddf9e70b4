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

void runScenario(std::ostream& out, const std::string& name, const std::vector<std::string>& changes, int runs)
{
  std::size_t steps = 0, ok = 0, lost = 0, inside = 0, inside_pose = 0, wrong = 0;
  double squared = 0, nees = 0;
  std::vector<double> errors;
  for (int k = 0; k < runs; ++k)
  {
    const std::uint64_t seed = studySeed(k);
    const FilterScenario scenario = playScenario(name, seed, changes);
    for (const FilterSample& sample : runFilter(scenario, seed - 1))
    {
      ++steps;
      lost += sample.step.verdict == Verdict::lost ? 1 : 0;
      if (sample.step.verdict != Verdict::ok) continue;
      ++ok;
      inside += sample.positionNees() < chiSquareQuantile(2, 0.95) ? 1 : 0;
      inside_pose += sample.nees() < chiSquareQuantile(3, 0.95) ? 1 : 0;
      wrong += sample.distance() > kWrong ? 1 : 0;
      if (sample.distance() > kWrong) continue;
      squared += square(sample.distance());
      nees += sample.nees();
    }
  }
  const auto share = [](std::size_t part, std::size_t whole)
  { return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, whole)); };
  out << "| " << name << " | " << runs << " | " << steps << std::fixed << std::setprecision(3) << " | "
      << share(ok, steps) << " | " << share(lost, steps) << " | " << share(inside, ok) << " | "
      << share(inside_pose, ok) << " | " << wrong << " | " << nees / static_cast<double>(std::max<std::size_t>(1, ok))
      << " | " << std::sqrt(squared / static_cast<double>(std::max<std::size_t>(1, ok))) << " |\n"
      << std::flush;
}

void run(std::ostream& out)
{
  out << "Wrong: more than " << kWrong << " m off while the verdict is ok; NEES and RMSE of what is ok and not wrong.\n"
      << "\n| scenario | runs | steps | ok | lost | truth in 95 % region of the position | of the pose | ok but wrong "
         "| "
         "NEES (3) | RMSE [m] |\n|---|---|---|---|---|---|---|---|---|---|\n";
  const int runs = studyRuns(20);
  for (const std::string name : {"tracking", "kidnap", "goal-corners", "half-field", "room"})
    runScenario(out, name, {}, runs);
  runScenario(out, "long", {"Simulation.duration_s=60"}, runs);
  runScenario(out, "symmetric", {}, std::max(1, runs / 5));
}

const RegisterStudy kStudy("filter_consistency",
                           "While the verdict is ok: how often is the true pose inside the stated 95 % region?", run);
}  // namespace
}  // namespace mrpt_ext
