#include "mrpt_ext/evaluation/run_merge.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mrpt_ext/evaluation/method_comparison.h"
#include "mrpt_ext/evaluation/rmse_interval.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
/// Median over the parts that have the number; `get` returns it.
template <typename Part, typename Get>
OptionalNumber medianOf(const std::vector<const Part*>& parts, Get get)
{
  std::vector<double> values;
  for (const Part* part : parts)
    if (const OptionalNumber number = std::invoke(get, *part)) values.push_back(*number);
  return median(std::move(values));
}

template <typename Part>
ErrorStatistics mergeStatistics(const std::vector<const Part*>& parts, ErrorStatistics Part::*member)
{
  const auto over = [&](OptionalNumber ErrorStatistics::*number)
  { return medianOf(parts, [&](const Part& part) { return part.*member.*number; }); };
  ErrorStatistics merged;
  merged.count = static_cast<std::size_t>(std::llround(
      medianOf(parts, [&](const Part& part) { return OptionalNumber(static_cast<double>((part.*member).count)); })
          .value_or(0)));
  merged.rmse = over(&ErrorStatistics::rmse);
  merged.mean = over(&ErrorStatistics::mean);
  merged.median = over(&ErrorStatistics::median);
  merged.std = over(&ErrorStatistics::std);
  merged.min = over(&ErrorStatistics::min);
  merged.max = over(&ErrorStatistics::max);
  merged.p95 = over(&ErrorStatistics::p95);
  return merged;
}

MethodScore mergeMethod(const std::vector<const MethodScore*>& parts)
{
  MethodScore merged;
  merged.name = parts.front()->name;
  merged.continuous = parts.front()->continuous;
  merged.oracle = parts.front()->oracle;
  merged.estimates = medianOf(parts, &MethodScore::estimates);
  merged.availability = medianOf(parts, &MethodScore::availability);
  merged.ambiguous = medianOf(parts, &MethodScore::ambiguous);
  merged.position_error_m = mergeStatistics(parts, &MethodScore::position_error_m);
  merged.heading_error_deg = mergeStatistics(parts, &MethodScore::heading_error_deg);
  merged.position_error_whole_run_m = mergeStatistics(parts, &MethodScore::position_error_whole_run_m);
  merged.position_error_with_detections_m = mergeStatistics(parts, &MethodScore::position_error_with_detections_m);
  merged.position_error_blind_m = mergeStatistics(parts, &MethodScore::position_error_blind_m);
  for (const MethodScore* part : parts)
    if (part->position_error_m.rmse) merged.trial_rmse.push_back(*part->position_error_m.rmse);
  if (const auto interval = medianInterval(merged.trial_rmse))
  {
    merged.rmse_low = interval->low;
    merged.rmse_high = interval->high;
  }
  merged.step_ms_median = medianOf(parts, &MethodScore::step_ms_median);
  merged.step_ms_p95 = medianOf(parts, &MethodScore::step_ms_p95);
  merged.step_ms_p99 = medianOf(parts, &MethodScore::step_ms_p99);
  merged.step_ms_max = medianOf(parts, &MethodScore::step_ms_max);
  return merged;
}

std::vector<MethodScore> mergeMethods(const std::vector<RunScore>& trials)
{
  std::vector<std::vector<const MethodScore*>> groups;  // in order of first appearance
  for (const RunScore& trial : trials)
    for (const MethodScore& method : trial.methods)
    {
      const auto group = std::find_if(groups.begin(), groups.end(),
                                      [&](const auto& members) { return members.front()->name == method.name; });
      if (group == groups.end())
        groups.push_back({&method});
      else
        group->push_back(&method);
    }
  std::vector<MethodScore> merged;
  for (const auto& group : groups) merged.push_back(mergeMethod(group));
  return merged;
}

template <typename Part>
std::vector<const Part*> partsOf(const std::vector<RunScore>& trials, Part RunScore::*member)
{
  std::vector<const Part*> parts;
  for (const RunScore& trial : trials) parts.push_back(&(trial.*member));
  return parts;
}

std::map<std::string, BiasScore> mergeBiases(const std::vector<const FilterScore*>& parts)
{
  std::map<std::string, std::vector<const BiasScore*>> groups;
  for (const FilterScore* part : parts)
    for (const auto& [name, bias] : part->biases) groups[name].push_back(&bias);
  std::map<std::string, BiasScore> merged;
  for (const auto& [name, biases] : groups)
    merged[name] = {medianOf(biases, &BiasScore::mean), medianOf(biases, &BiasScore::std)};
  return merged;
}

FilterScore mergeFilter(const std::vector<const FilterScore*>& parts)
{
  FilterScore merged;
  for (const auto number :
       {&FilterScore::particles_min, &FilterScore::particles_median, &FilterScore::particles_max,
        &FilterScore::nees_mean, &FilterScore::nees_band_low, &FilterScore::nees_band_high, &FilterScore::coverage_95,
        &FilterScore::effective_sample_ratio_min, &FilterScore::lost_steps, &FilterScore::reseeds,
        &FilterScore::late_estimates, &FilterScore::most_steps_late})
    merged.*number = medianOf(parts, number);
  merged.biases = mergeBiases(parts);
  return merged;
}

std::map<std::string, LandmarkScore> mergeLandmarks(const std::vector<RunScore>& trials)
{
  std::map<std::string, std::vector<const LandmarkScore*>> groups;
  for (const RunScore& trial : trials)
    for (const auto& [id, landmark] : trial.landmarks) groups[id].push_back(&landmark);
  std::map<std::string, LandmarkScore> merged;
  for (const auto& [id, parts] : groups)
    for (const auto number : {&LandmarkScore::seen, &LandmarkScore::associated, &LandmarkScore::inlier_rate,
                              &LandmarkScore::residual_mean, &LandmarkScore::residual_std})
      merged[id].*number = medianOf(parts, number);
  return merged;
}

CostScore mergeCost(const std::vector<const CostScore*>& parts)
{
  CostScore merged;
  for (const auto number :
       {&CostScore::cpu_s, &CostScore::wall_s, &CostScore::peak_memory_mb, &CostScore::realtime_factor})
    merged.*number = medianOf(parts, number);
  return merged;
}

/// Means over the trials that have them, so that they add up to one.
VerdictShares meanShares(const std::vector<RunScore>& trials)
{
  VerdictShares mean;
  for (const auto share : {&VerdictShares::ok, &VerdictShares::ambiguous, &VerdictShares::lost})
  {
    double sum = 0, count = 0;
    for (const RunScore& trial : trials)
      if (const auto& value = trial.verdict_shares.*share)
      {
        sum += *value;
        ++count;
      }
    if (count > 0) mean.*share = sum / count;
  }
  return mean;
}

void mergeVerdict(RunScore& merged, const std::vector<RunScore>& trials)
{
  for (auto trial = trials.begin(); merged.hints.empty() && trial != trials.end(); ++trial) merged.hints = trial->hints;
  merged.verdict_shares = meanShares(trials);
  merged.verdict = Verdict::ok;
  for (const RunScore& trial : trials) merged.verdict = std::max(merged.verdict, trial.verdict);
  const auto is_worst = [&](const RunScore& trial) { return trial.verdict == merged.verdict; };
  const auto count = std::count_if(trials.begin(), trials.end(), is_worst);
  const RunScore& first = *std::find_if(trials.begin(), trials.end(), is_worst);
  merged.verdict_reason = std::to_string(count) + " of " + std::to_string(trials.size()) + " trials " +
                          toString(merged.verdict) + "; trial " + std::to_string(first.trials.front().trial) + ": " +
                          first.verdict_reason;
}

void mergeTrials(RunScore& merged, const std::vector<RunScore>& trials)
{
  double judged = 0, successes = 0;
  for (const RunScore& trial : trials)
  {
    merged.interrupted = merged.interrupted || trial.interrupted;
    for (const TrialScore& detail : trial.trials)
    {
      merged.trials.push_back(detail);
      judged += detail.success ? 1 : 0;
      successes += detail.success.value_or(false) ? 1 : 0;
    }
  }
  if (judged > 0) merged.success_rate = successes / judged;
}
}  // namespace

RunScore mergeScores(const std::vector<RunScore>& trials)
{
  if (trials.empty()) return {};
  if (trials.size() == 1) return trials.front();
  RunScore merged;
  merged.judged_method = trials.front().judged_method;
  merged.limits = trials.front().limits;
  merged.methods = mergeMethods(trials);
  merged.filter = mergeFilter(partsOf(trials, &RunScore::filter));
  merged.landmarks = mergeLandmarks(trials);
  const auto limits = partsOf(trials, &RunScore::limit);
  merged.limit = {medianOf(limits, &LimitScore::position_rmse_m), medianOf(limits, &LimitScore::heading_rmse_deg),
                  limits.front()->why_none};
  merged.comparisons = compareMethods(merged, trials);
  merged.cost = mergeCost(partsOf(trials, &RunScore::cost));
  std::vector<const RunScore*> whole;
  for (const RunScore& trial : trials) whole.push_back(&trial);
  merged.converged_at_s = medianOf(whole, &RunScore::converged_at_s);
  mergeTrials(merged, trials);
  mergeVerdict(merged, trials);
  return merged;
}
}  // namespace mrpt_ext
