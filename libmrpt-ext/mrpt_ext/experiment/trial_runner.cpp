#include "mrpt_ext/experiment/trial_runner.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/experiment/method_factory.h"
#include "mrpt_ext/experiment/object_tracker.h"
#include "mrpt_ext/experiment/oracle_trajectories.h"
#include "mrpt_ext/experiment/run_verdict.h"
#include "mrpt_ext/scene/playback_recorder.h"

namespace mrpt_ext
{
namespace
{
using Clock = std::chrono::steady_clock;

double threadCpuSeconds()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

bool hasDetection(const Frame& frame)
{
  return !frame.fixes.empty() || std::any_of(frame.readings.begin(), frame.readings.end(),
                                             [](const Reading& reading) { return !reading.detections.empty(); });
}

void record(const Estimate& estimate, const Frame& frame, double milliseconds, MethodTrajectory& trajectory)
{
  trajectory.step_milliseconds.push_back(milliseconds);
  if (hasDetection(frame))
  {
    ++trajectory.frames_offered;
    if (estimate.point) ++trajectory.frames_answered;
    if (!estimate.point && estimate.ambiguous) ++trajectory.frames_ambiguous;
  }
  if (estimate.point) trajectory.points.push_back(*estimate.point);
}

/// Of a method without reasons.
Verdict verdictOf(const Estimate& estimate)
{
  if (estimate.point) return estimate.point->verdict;
  return estimate.ambiguous ? Verdict::ambiguous : Verdict::lost;
}

/// `reason_before`: of the verdict one frame before.
void recordFilter(const FilterStep& step, const BiasModel& biases, const Estimate& estimate, double time,
                  const std::string& reason_before, RunRecord& run)
{
  run.verdicts.add(time, step.verdict, step.reason);
  run.filter.particle_counts.push_back(step.particles);
  run.filter.effective_sample_ratio_min =
      std::min(run.filter.effective_sample_ratio_min.value_or(1.0), step.effective_ratio);
  if (step.verdict == Verdict::lost) ++run.filter.lost_steps;
  if (step.search_stopped) ++run.filter.stopped_searches;
  run.filter.detections_left_out += step.detections_left_out;
  if (step.reseeded) run.filter.reseedings.push_back({time, reason_before});
  for (std::size_t k = 0; k < step.biases.size(); ++k)
  {
    const double unit = fileUnit(biases[k]);
    run.biases.push_back({time, biasName(biases[k]), unit * step.biases[k].mean, unit * step.biases[k].std});
  }
  int rank = 0;
  for (const PoseHypothesis& h : estimate.candidates)
    run.hypotheses.push_back({time, rank++, h.pose.mean, h.weight, h.source});
}

std::map<std::string, LandmarkRecord> landmarkRecords(const FilterLocalizer& filter, const LandmarkTable& map)
{
  std::map<std::string, LandmarkRecord> records;
  const std::vector<LandmarkHistory> histories = filter.landmarkHistories();
  for (std::size_t j = 0; j < map.size(); ++j)
  {
    const LandmarkHistory& history = histories[j];
    LandmarkRecord r;
    r.seen = static_cast<std::size_t>(std::llround(history.seen));
    r.associated = history.associated;
    if (history.seen > 0) r.inlier_rate = history.associated / history.seen;
    if (history.residual_weight > 0)
    {
      r.residual_mean = history.residual_sum / history.residual_weight;
      r.residual_std =
          std::sqrt(std::max(0.0, history.residual_sum2 / history.residual_weight - square(r.residual_mean)));
    }
    const std::string name = map[j].id != kNoId ? std::to_string(map[j].id) : "anonymous_" + std::to_string(j);
    records[name] = r;
  }
  return records;
}

void finish(const Methods& methods, const TrialInput& input, RunRecord& run)
{
  if (!methods.filter)
  {
    const VerdictWithReason verdict = verdictOfClosedForms(run);
    run.verdict = verdict.verdict;
    run.verdict_reason = verdict.reason;
    return;
  }
  for (const Mode& mode : methods.filter->lastStep().modes.modes)
    if (mode.weight > 0.01) run.filter.modes_at_end.push_back({mode.pose, mode.weight});
  run.landmarks = landmarkRecords(*methods.filter, input.methods.map());
  const VerdictWithReason verdict = verdictOfFilter(run, methods.filter->lastStep());
  run.verdict = verdict.verdict;
  run.verdict_reason = verdict.reason;
}
}  // namespace

TrialOutcome runTrial(const TrialInput& input, std::uint64_t seed, int trial)
{
  const auto started = Clock::now();
  const double cpu_before = threadCpuSeconds();
  TrialOutcome outcome;
  RunRecord& run = outcome.record;
  run.trial = trial;
  run.seed = seed;
  const Methods methods = input.methods.make(seed, trial);
  OracleTrajectories oracles(input.run.context.truth);
  ObjectTracker objects(input.run.log.overview.odometry);
  for (const auto& localizer : methods.localizers)
    run.methods.push_back({.name = localizer->name(), .continuous = localizer->continuous()});

  const MethodTrajectory* judged = judgedMethod(run);
  const std::size_t count = input.run.log.frames;
  PlaybackRecorder playback(count, input.methods.map());
  FrameSynchronizer frames = framesOf(input.run);
  std::optional<Frame> last;
  for (std::size_t k = 0; !input.stop; ++k)
  {
    auto frame = frames.next();
    if (!frame) break;
    objects.add(frames.takeObjectFrames());
    const std::string reason_before = methods.filter ? methods.filter->lastStep().reason : "";
    for (std::size_t m = 0; m < methods.localizers.size(); ++m)
    {
      const auto before = Clock::now();
      const Estimate estimate = methods.localizers[m]->process(*frame);
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - before).count();
      record(estimate, *frame, ms, run.methods[m]);
      if (methods.localizers[m].get() == methods.filter)
      {
        recordFilter(methods.filter->lastStep(), methods.filter->particles().bias_states, estimate, frame->time,
                     reason_before, run);
        if (estimate.point) objects.locate(*estimate.point, run.objects);
      }
      else if (&run.methods[m] == judged)
        run.verdicts.add(frame->time, verdictOf(estimate), {});
      else if (!run.methods[m].continuous)
        oracles.add(run.methods[m], estimate, frame->time);
    }
    playback.add(*frame, methods.filter, run.playback);
    if (input.on_frame) input.on_frame(k, *frame, methods.filter);
    if (input.on_progress) input.on_progress(static_cast<double>(k + 1) / static_cast<double>(count));
    last = std::move(*frame);
  }
  run.interrupted = input.stop;
  for (MethodTrajectory& trajectory : oracles.take()) run.methods.push_back(std::move(trajectory));
  finish(methods, input, run);
  if (last)
    outcome.final_step =
        playbackStep(*last, methods.filter, input.methods.map(), std::numeric_limits<std::size_t>::max());
  run.wall_s = std::chrono::duration<double>(Clock::now() - started).count();
  run.cpu_s = threadCpuSeconds() - cpu_before;
  return outcome;
}
}  // namespace mrpt_ext
