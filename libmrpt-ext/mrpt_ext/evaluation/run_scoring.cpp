#include "mrpt_ext/evaluation/run_scoring.h"

#include <algorithm>

#include "mrpt_ext/evaluation/detection_gaps.h"
#include "mrpt_ext/evaluation/method_comparison.h"
#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/evaluation/rmse_interval.h"
#include "mrpt_ext/evaluation/truth_frame.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kParticleFilter = "particle_filter";

ErrorStatistics positionStatistics(const std::vector<ErrorSample>& errors, double from)
{
  std::vector<double> sample;
  for (const ErrorSample& error : errors)
    if (error.stamp >= from) sample.push_back(error.position_m);
  return errorStatistics(std::move(sample));
}

ErrorStatistics headingStatistics(const std::vector<ErrorSample>& errors, double from)
{
  std::vector<double> sample;
  for (const ErrorSample& error : errors)
    if (error.stamp >= from && error.heading_deg) sample.push_back(*error.heading_deg);
  return errorStatistics(std::move(sample));
}

MethodScore describe(const MethodTrajectory& trajectory)
{
  MethodScore score;
  score.name = trajectory.name;
  score.continuous = trajectory.continuous;
  score.oracle = trajectory.oracle;
  score.estimates = static_cast<double>(trajectory.points.size());
  score.ambiguous = static_cast<double>(trajectory.frames_ambiguous);
  if (trajectory.frames_offered > 0)
    score.availability =
        static_cast<double>(trajectory.frames_answered) / static_cast<double>(trajectory.frames_offered);
  score.step_ms_median = quantile(trajectory.step_milliseconds, 0.5);
  score.step_ms_p95 = quantile(trajectory.step_milliseconds, 0.95);
  score.step_ms_p99 = quantile(trajectory.step_milliseconds, 0.99);
  score.step_ms_max = quantile(trajectory.step_milliseconds, 1.0);
  return score;
}

/// Errors of a method over the whole run; none for dead reckoning that cannot be aligned.
std::vector<ErrorSample> errorsOfMethod(const MethodTrajectory& trajectory, const RunContext& context)
{
  if (trajectory.name != kOdometryMethod) return errorsOf(judge(trajectory, context));
  MethodTrajectory aligned = trajectory;
  if (!alignWithTruth(aligned, context.truth)) return {};
  return errorsOf(judge(aligned, context));
}

FilterScore describe(const FilterRecord& filter)
{
  std::vector<double> counts(filter.particle_counts.begin(), filter.particle_counts.end());
  FilterScore score;
  score.particles_min = quantile(counts, 0.0);
  score.particles_median = quantile(counts, 0.5);
  score.particles_max = quantile(std::move(counts), 1.0);
  if (filter.particle_counts.empty()) return score;  // no particle filter ran
  score.effective_sample_ratio_min = filter.effective_sample_ratio_min;
  score.lost_steps = static_cast<double>(filter.lost_steps);
  score.reseeds = static_cast<double>(filter.reseedings.size());
  score.late_estimates = static_cast<double>(filter.late_estimates);
  score.most_steps_late = static_cast<double>(filter.most_steps_late);
  score.modes_at_end = filter.modes_at_end;
  return score;
}

std::map<std::string, BiasScore> atTheEnd(const DiskBackedSequence<BiasRow>& rows)
{
  std::map<std::string, BiasScore> scores;
  for (const BiasRow& row : rows) scores[row.name] = {row.mean, row.std};
  return scores;
}

/// Every `ok` estimate with a truth at its time; with a sparse truth those of `judged`.
double countOkOutside(const MethodTrajectory& trajectory, const std::vector<JudgedEstimate>& judged,
                      const RunContext& context, const ConvergenceLimits& limits)
{
  std::size_t count = 0;
  const auto add = [&](const JudgedEstimate& entry)
  { count += entry.estimate.verdict == Verdict::ok && !withinLimits(errorOf(entry), limits) ? 1 : 0; };
  if (context.truth_is_sparse)
    std::for_each(judged.begin(), judged.end(), add);
  else
    for (const PoseEstimate& estimate : trajectory.points)
      if (const auto truth = truthAt(context, estimate.time)) add({estimate.time, estimate, *truth});
  return static_cast<double>(count);
}

void addConsistency(FilterScore& score, const MethodTrajectory& trajectory, const RunContext& context,
                    const ConvergenceLimits& limits, std::optional<double> from)
{
  // Judged at the time of the estimate: dead reckoning would add an error that is not in the covariance.
  std::vector<JudgedEstimate> judged = judgeAtOwnTimes(trajectory, context);
  score.nees = neesOf(judged);
  std::vector<JudgedEstimate> believed = judged;
  std::erase_if(believed, [](const JudgedEstimate& entry) { return entry.estimate.verdict != Verdict::ok; });
  score.coverage_95 = coverage(believed, 0.95);
  score.ok_outside = countOkOutside(trajectory, judged, context, limits);
  if (!from) return;
  std::erase_if(judged, [&](const JudgedEstimate& entry) { return entry.stamp < *from; });
  const Consistency nees = consistency(judged);
  score.nees_mean = nees.mean;
  score.nees_band_low = nees.band_low;
  score.nees_band_high = nees.band_high;
}

std::map<std::string, LandmarkScore> describe(const std::map<std::string, LandmarkRecord>& landmarks)
{
  std::map<std::string, LandmarkScore> scores;
  for (const auto& [id, landmark] : landmarks)
  {
    LandmarkScore& score = scores[id];
    score = {static_cast<double>(landmark.seen), landmark.associated, {}, {}, {}};
    if (landmark.seen > 0) score.inlier_rate = landmark.inlier_rate;
    if (landmark.associated > 0)
    {
      score.residual_mean = landmark.residual_mean;
      score.residual_std = landmark.residual_std;
    }
  }
  return scores;
}

/// With times since the start of the log.
std::vector<VerdictSpell> spellsInLog(std::vector<VerdictSpell> spells, double start)
{
  for (VerdictSpell& spell : spells)
  {
    spell.from -= start;
    spell.to -= start;
  }
  return spells;
}

CostScore describeCost(const RunContext& context, const RunRecord& record)
{
  CostScore cost{record.cpu_s, record.wall_s, record.peak_memory_mb, {}};
  if (record.wall_s > 0) cost.realtime_factor = context.duration_s / record.wall_s;
  return cost;
}

/// Fills the errors, the convergence and the success of all methods.
void judgeMethods(RunScore& score, const RunContext& context, const RunRecord& record, const ConvergenceLimits& limits)
{
  const MethodTrajectory* judged = judgedMethod(record);
  if (judged) score.judged_method = judged->name;
  const std::vector<double> stamps = scoringStamps(context);
  score.truth_stamps = stamps.size();
  score.truth_is_sparse = context.truth_is_sparse;
  std::optional<double> count_from;
  if (!judged) count_from = context.start_time;

  TrialScore& trial = score.trials.front();
  for (const MethodTrajectory& trajectory : record.methods)
  {
    MethodScore method = describe(trajectory);
    method.errors = errorsOfMethod(trajectory, context);
    if (&trajectory == judged && !stamps.empty())
    {
      count_from = convergenceStamp(method.errors, limits);
      // The success of an unfinished trial is not known.
      if (!record.interrupted && tellsSuccess(stamps, context.start_time, limits))
        trial.success = isSuccess(method.errors, context.start_time, limits);
      if (count_from) trial.converged_at_s = *count_from - context.start_time;
    }
    score.methods.push_back(std::move(method));
  }
  if (judged && !count_from)
    if (const std::string hint = truthOffsetHint(findTruthOffset(judge(*judged, context))); !hint.empty())
      score.hints.push_back(hint);
  for (MethodScore& method : score.methods)
  {
    method.position_error_whole_run_m = positionStatistics(method.errors, context.start_time);
    if (!count_from) continue;
    method.position_error_m = positionStatistics(method.errors, *count_from);
    const ErrorsByDetections split = splitByDetections(method.errors, context);
    method.position_error_with_detections_m = positionStatistics(split.with_detections, *count_from);
    method.position_error_blind_m = positionStatistics(split.blind, *count_from);
    if (const auto interval = rmseInterval(method.errors, *count_from))
    {
      method.rmse_low = interval->low;
      method.rmse_high = interval->high;
    }
    method.heading_error_deg = headingStatistics(method.errors, *count_from);
    if (judged && method.name == judged->name) trial.rmse = method.position_error_m.rmse;
  }
  if (judged && count_from) score.comparisons = compareMethods(score, *count_from);
  if (judged) addConsistency(score.filter, *judged, context, limits, count_from);
}
}  // namespace

const MethodTrajectory* judgedMethod(const RunRecord& record)
{
  const MethodTrajectory* first = nullptr;
  for (const MethodTrajectory& trajectory : record.methods)
  {
    if (!trajectory.continuous || trajectory.name == kOdometryMethod) continue;
    if (trajectory.name == kParticleFilter) return &trajectory;
    if (!first) first = &trajectory;
  }
  return first;
}

RunScore scoreRun(const RunContext& context, const RunRecord& record, const ConvergenceLimits& limits)
{
  RunScore score;
  score.filter = describe(record.filter);
  score.filter.biases = atTheEnd(record.biases);
  score.landmarks = describe(record.landmarks);
  score.cost = describeCost(context, record);
  score.limits = limits;
  score.hints = record.hints;
  score.verdict_shares = record.verdicts.shares();
  score.verdict_spells = spellsInLog(record.verdicts.spells(), context.start_time);
  score.verdict = record.verdict;
  score.verdict_reason = record.verdict_reason;
  score.interrupted = record.interrupted;
  score.trials.push_back({record.trial, record.seed, {}, record.verdict, {}, {}});
  judgeMethods(score, context, record, limits);
  score.converged_at_s = score.trials.front().converged_at_s;
  if (score.trials.front().success) score.success_rate = *score.trials.front().success ? 1.0 : 0.0;
  return score;
}
}  // namespace mrpt_ext
