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
constexpr std::array kKidnapped = {40.55, 80.55};  // [s], see ini/landmark-simulator/kidnap.ini
constexpr double kWindow = 1;                      // [s]
constexpr std::size_t kEnough = 3;                 // detections within it
constexpr double kRight = 0.5, kRightHeading = degToRad(15.0);

bool isRight(const FilterSample& sample)
{
  return sample.distance() < kRight && std::abs(sample.error.z()) < kRightHeading;
}

std::size_t detectionsOf(const Frame& frame)
{
  std::size_t count = 0;
  for (const Reading& reading : frame.readings) count += reading.detections.size();
  return count;
}

/// Time after `from` until the filter is right for one second without a break [s]; only times with enough detections
/// count.
std::optional<double> timeToRecover(const std::vector<FilterSample>& samples, double from, double until)
{
  double counted = 0, right_since = until;
  for (std::size_t k = 1; k < samples.size() && samples[k].time < until; ++k)
  {
    if (samples[k].time <= from) continue;
    if (!isRight(samples[k]))
      right_since = until;
    else if (right_since == until)
      right_since = samples[k].time;
    else if (samples[k].time - right_since >= 1)
      return counted;
    std::size_t seen = 0;
    for (std::size_t j = k + 1; j-- > 0 && samples[j].time > samples[k].time - kWindow;)
      seen += samples[j].time > from ? detectionsOf(*samples[j].frame) : 0;
    const bool waiting_for_more = samples[k].time - from < kWindow;
    if (right_since == until && (seen >= kEnough || waiting_for_more))
      counted += samples[k].time - std::max(from, samples[k - 1].time);
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
    const std::uint64_t seed = studySeed(k);
    const FilterScenario scenario = playScenario("kidnap", seed);
    const std::vector<FilterSample> samples = runFilter(scenario, seed - 1);
    for (std::size_t n = 0; n < kKidnapped.size(); ++n)
    {
      const double until = n + 1 < kKidnapped.size() ? kKidnapped[n + 1] : 1e9;
      const auto time = timeToRecover(samples, kKidnapped[n], until);
      if (!time)
        out << "run " << k << ": no recovery from kidnapping " << n + 1 << "\n\n";
      else if (*time > 3)
        out << "run " << k << ": " << *time << " s to recover from kidnapping " << n + 1 << "\n\n";
      never += time ? 0 : 1;
      late += time && *time > 3 ? 1 : 0;
      if (time) times.push_back(*time);
    }
    double since = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
    {
      const FilterSample& sample = samples[i];
      const bool wrong = sample.step.verdict == Verdict::ok && !isRight(sample);
      since = wrong ? since + sample.time - samples[i - 1].time : 0;
      wrong_and_ok += wrong ? sample.time - samples[i - 1].time : 0;
      worst_ok = std::max(worst_ok, since);
      const bool undisturbed = sample.time > 5 && (sample.time < kKidnapped[0] || sample.time > kKidnapped[0] + 10) &&
                               (sample.time < kKidnapped[1] || sample.time > kKidnapped[1] + 10);
      false_alarms += undisturbed && (sample.step.reseeded || sample.step.verdict == Verdict::lost) ? 1 : 0;
    }
  }
  const ErrorStatistics statistics = errorStatistics(times);
  out << "| runs | kidnappings | recovered within 3 s | never | median [s] | 95 % | worst | ok at a wrong pose, per "
         "run [s] | longest [s] | false alarms [steps] |\n|---|---|---|---|---|---|---|---|---|---|\n| "
      << runs << " | " << 2 * runs << " | " << 2 * runs - late - never << " | " << never << std::fixed
      << std::setprecision(2) << " | " << *statistics.median << " | " << *statistics.p95 << " | " << *statistics.max
      << " | " << wrong_and_ok / runs << " | " << worst_ok << " | " << false_alarms << " |\n";
}

const RegisterStudy kStudy("filter_kidnap", "How soon is the pose right again after a kidnapping?", run);
}  // namespace
}  // namespace mrpt_ext
