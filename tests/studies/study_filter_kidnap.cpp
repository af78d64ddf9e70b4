#include <cmath>
#include <iomanip>
#include <optional>

#include "filter_scenario.h"
#include "mrpt_ext/evaluation/error_statistics.h"
#include "study.h"

namespace mrpt_ext
{
namespace
{
constexpr std::array kCarriedAway = {40.55, 80.55};  // [s], see ini/landmark-simulator/kidnap.ini
constexpr double kWindow = 1;                        // [s]
constexpr std::size_t kEnough = 3;                   // detections within it
constexpr double kBack = 0.5, kBackHeading = degToRad(15.0);

bool isBack(const FilterMoment& moment)
{
  return moment.distance() < kBack && std::abs(moment.error.z()) < kBackHeading;
}

std::size_t detectionsOf(const Frame& frame)
{
  std::size_t count = 0;
  for (const Reading& reading : frame.readings) count += reading.detections.size();
  return count;
}

/// Seconds after `from` until the filter is right for a second on end; only those count in which enough detections
/// arrive.
std::optional<double> timeToReturn(const std::vector<FilterMoment>& moments, double from, double until)
{
  double counted = 0, right_since = until;
  for (std::size_t k = 1; k < moments.size() && moments[k].time < until; ++k)
  {
    if (moments[k].time <= from) continue;
    if (!isBack(moments[k]))
      right_since = until;
    else if (right_since == until)
      right_since = moments[k].time;
    else if (moments[k].time - right_since >= 1)
      return counted;
    std::size_t seen = 0;
    for (std::size_t j = k + 1; j-- > 0 && moments[j].time > moments[k].time - kWindow;)
      seen += moments[j].time > from ? detectionsOf(*moments[j].frame) : 0;
    const bool waiting_for_more = moments[k].time - from < kWindow;
    if (right_since == until && (seen >= kEnough || waiting_for_more))
      counted += moments[k].time - std::max(from, moments[k - 1].time);
  }
  return std::nullopt;
}

void run(std::ostream& out)
{
  const int runs = studyRuns(50);
  std::vector<double> times;
  int late = 0, never = 0, false_alarms = 0;
  double worst_ok = 0, wrong_and_ok = 0;
  for (int k = 0; k < runs; ++k)
  {
    const FilterScenario scenario = playScenario("kidnap", static_cast<std::uint64_t>(k) + 1);
    const std::vector<FilterMoment> moments = runFilter(scenario, static_cast<std::uint64_t>(k));
    for (std::size_t n = 0; n < kCarriedAway.size(); ++n)
    {
      const double until = n + 1 < kCarriedAway.size() ? kCarriedAway[n + 1] : 1e9;
      const auto time = timeToReturn(moments, kCarriedAway[n], until);
      if (!time)
        out << "run " << k << ": never back from kidnapping " << n + 1 << "\n\n";
      else if (*time > 3)
        out << "run " << k << ": " << *time << " s to come back from kidnapping " << n + 1 << "\n\n";
      never += time ? 0 : 1;
      late += time && *time > 3 ? 1 : 0;
      if (time) times.push_back(*time);
    }
    double since = 0;
    for (std::size_t i = 1; i < moments.size(); ++i)
    {
      const FilterMoment& moment = moments[i];
      const bool wrong = moment.step.verdict == Verdict::ok && !isBack(moment);
      since = wrong ? since + moment.time - moments[i - 1].time : 0;
      wrong_and_ok += wrong ? moment.time - moments[i - 1].time : 0;
      worst_ok = std::max(worst_ok, since);
      const bool undisturbed = moment.time > 5 &&
                               (moment.time < kCarriedAway[0] || moment.time > kCarriedAway[0] + 10) &&
                               (moment.time < kCarriedAway[1] || moment.time > kCarriedAway[1] + 10);
      false_alarms += undisturbed && (moment.step.reseeded || moment.step.verdict == Verdict::lost) ? 1 : 0;
    }
  }
  const ErrorStatistics statistics = errorStatistics(times);
  out << "| runs | kidnappings | back within 3 s | never back | median [s] | 95 % | worst | ok at a wrong place, per "
         "run [s] | longest [s] | false alarms [steps] |\n|---|---|---|---|---|---|---|---|---|---|\n| "
      << runs << " | " << 2 * runs << " | " << 2 * runs - late - never << " | " << never << std::fixed
      << std::setprecision(2) << " | " << *statistics.median << " | " << *statistics.p95 << " | " << *statistics.max
      << " | " << wrong_and_ok / runs << " | " << worst_ok << " | " << false_alarms << " |\n";
}

const RegisterStudy kStudy("filter_kidnap", "How soon is a robot that was carried away found again?", run);
}  // namespace
}  // namespace mrpt_ext
