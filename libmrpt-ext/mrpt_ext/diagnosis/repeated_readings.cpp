#include "mrpt_ext/diagnosis/repeated_readings.h"

#include <algorithm>
#include <map>
#include <utility>

namespace mrpt_ext
{
namespace
{
constexpr int kMostRounds = 3, kMostHalvings = 8;
constexpr std::size_t kPerUnknown = 6, kFewest = 40;  // readings that stay: what calibrate() needs, twice

/// As `times` says, with shorter ones where fewer than `least` would stay.
std::vector<bool> independentOnes(const CalibrationProblem& problem, CorrelationTimes& times, std::size_t least)
{
  for (int k = 0;; ++k)
  {
    std::vector<bool> independent = independentReadings(problem, times);
    const auto kept = static_cast<std::size_t>(std::count(independent.begin(), independent.end(), true));
    if (kept >= least || kept == independent.size()) return independent;
    for (auto& [kind, time] : times) time = k < kMostHalvings ? time / 2 : 0;
  }
}

/// Leaves out readings that have the error of one shortly before, and the same share of those that no landmark is near.
void keepIndependent(CalibrationData& data, std::size_t least)
{
  const std::vector<bool> independent = independentOnes(data.problem, data.correlation_times, least);
  struct KindCount
  {
    std::size_t all = 0, kept = 0;
    double unmatched = 0;
  };
  std::map<std::pair<std::size_t, bool>, KindCount> counts;
  std::vector<CalibrationReading> kept;
  for (std::size_t i = 0; i < independent.size(); ++i)
  {
    const CalibrationReading& r = data.problem.readings[i];
    KindCount& count = counts[{r.sensor, r.is_range}];
    ++count.all;
    if (!independent[i]) continue;
    ++count.kept;
    kept.push_back(r);
  }
  data.repeated += independent.size() - kept.size();
  data.problem.readings = std::move(kept);
  std::erase_if(data.unmatched,
                [&](const UnmatchedReading& r)
                {
                  KindCount& count = counts[{r.sensor, r.is_range}];
                  if (count.all == 0) return false;
                  count.unmatched += static_cast<double>(count.kept) / static_cast<double>(count.all);
                  if (count.unmatched < 1) return true;
                  --count.unmatched;
                  return false;
                });
}
}  // namespace

std::optional<CalibrationResult> leaveOutRepeated(CalibrationData& data,
                                                  const std::vector<CalibrationUnknown>& unknowns)
{
  if (data.problem.odometry.empty() || !sensorsWithBearings(data).empty()) return {};
  const std::size_t least = std::max(kFewest, kPerUnknown * unknowns.size());
  for (int k = 0; k < kMostRounds; ++k)
  {
    CalibrationResult found = calibrate(data.problem, unknowns);
    if (found.status != SolveStatus::ok) return found;
    bool changed = false;
    for (const auto& [kind, time] : correlationTimes(data.problem, found.misfits))
    {
      double& longest = data.correlation_times[kind];
      changed = changed || time > longest;
      longest = std::max(longest, time);
    }
    if (!changed) return found;
    keepIndependent(data, least);
  }
  return {};
}
}  // namespace mrpt_ext
