#include "mrpt_ext/experiment/trial_runner.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/experiment/elapsed_time.h"
#include "mrpt_ext/experiment/method_factory.h"
#include "mrpt_ext/experiment/object_tracker.h"
#include "mrpt_ext/experiment/oracle_trajectories.h"
#include "mrpt_ext/experiment/run_verdict.h"
#include "mrpt_ext/localizers/sliced_localizer.h"
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

void record(const Estimate& estimate, const Frame& frame, MethodTrajectory& trajectory)
{
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
void recordStep(const FilterStep& step, const BiasModel& biases, const SlicedLocalizer::Finished& finished,
                const std::string& reason_before, RunRecord& run)
{
  const double time = finished.frame.time;
  run.verdicts.add(time, step.verdict, reasonWithLateness(step.reason, finished.steps_late));
  if (finished.steps_late > 0) ++run.filter.late_estimates;
  run.filter.most_steps_late = std::max(run.filter.most_steps_late, finished.steps_late);
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
  for (const PoseHypothesis& h : finished.estimate.candidates)
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

void setVerdict(const VerdictWithReason& verdict, const std::string& warning, RunRecord& run)
{
  run.verdict = verdict.verdict;
  run.verdict_reason = warning.empty() ? verdict.reason : verdict.reason + "; the log warns: " + warning;
}

void finishFilter(const FilterLocalizer& filter, const TrialInput& input, RunRecord& run)
{
  for (const Mode& mode : filter.lastStep().modes.modes)
    if (mode.weight > 0.01) run.filter.modes_at_end.push_back({mode.pose, mode.weight});
  run.landmarks = landmarkRecords(filter, input.methods.map());
  setVerdict(verdictOfFilter(run, filter.lastStep()), input.run.warning, run);
}

/// The filter goes first, in steps that end soon; all that is to be done with a frame then waits for it.
class Trial
{
 public:
  Trial(const TrialInput& input, std::uint64_t seed, int trial);
  TrialOutcome run();

 private:
  using Finished = SlicedLocalizer::Finished;

  void process(Frame frame);
  /// One step of the filter, with its time.
  void step();
  void recordFilter(const Finished& finished);
  /// The other methods, and what is shown.
  void complete(Frame frame);
  void finish();

  const TrialInput& input_;
  Methods methods_;
  std::optional<SlicedLocalizer> filter_;
  TrialOutcome outcome_;
  RunRecord& run_ = outcome_.record;
  OracleTrajectories oracles_;
  ObjectTracker objects_;
  PlaybackRecorder playback_;
  const MethodTrajectory* judged_ = nullptr;
  std::size_t completed_ = 0;  // frames
  std::optional<Frame> last_;
  std::string reason_;  // of the filter's verdict one frame before
};

Trial::Trial(const TrialInput& input, std::uint64_t seed, int trial)
    : input_(input),
      methods_(input.methods.make(seed, trial)),
      oracles_(input.run.context.truth),
      objects_(input.run.log.overview.odometry),
      playback_(input.run.log.frames, input.methods.map())
{
  run_.trial = trial;
  run_.seed = seed;
  for (const auto& localizer : methods_.localizers)
    run_.methods.push_back({.name = localizer->name(), .continuous = localizer->continuous()});
  judged_ = judgedMethod(run_);
  if (!methods_.filter) return;
  filter_.emplace([filter = methods_.filter](const Frame& frame) { return filter->process(frame); },
                  methods_.step_budget_ms);
  reason_ = methods_.filter->lastStep().reason;
}

TrialOutcome Trial::run()
{
  const auto started = Clock::now();
  const double cpu_before = threadCpuSeconds();
  FrameSynchronizer frames = framesOf(input_.run);
  while (!input_.stop)
  {
    auto frame = frames.next();
    if (!frame) break;
    objects_.add(frames.takeObjectFrames());
    process(std::move(*frame));
  }
  while (!input_.stop && filter_ && filter_->hasWaiting())
  {
    filter_->goOn();
    step();
  }
  run_.interrupted = input_.stop;
  for (MethodTrajectory& trajectory : oracles_.take()) run_.methods.push_back(std::move(trajectory));
  finish();
  run_.wall_s = 1e-3 * millisecondsSince(started);
  run_.cpu_s = threadCpuSeconds() - cpu_before + (filter_ ? filter_->cpuSeconds() : 0);
  return std::move(outcome_);
}

void Trial::process(Frame frame)
{
  if (!filter_) return complete(std::move(frame));
  filter_->add(std::move(frame));
  step();
}

void Trial::step()
{
  double milliseconds = 0;
  while (true)
  {
    const auto before = Clock::now();
    std::optional<Finished> finished = filter_->next();
    milliseconds += millisecondsSince(before);
    if (!finished) break;
    recordFilter(*finished);
    complete(std::move(finished->frame));
  }
  run_.methods.front().step_milliseconds.push_back(milliseconds);
}

void Trial::recordFilter(const Finished& finished)
{
  const Estimate& estimate = finished.estimate;
  record(estimate, finished.frame, run_.methods.front());
  recordStep(methods_.filter->lastStep(), methods_.filter->particles().bias_states, finished, reason_, run_);
  if (estimate.point) objects_.locate(*estimate.point, run_.objects);
  reason_ = methods_.filter->lastStep().reason;
}

void Trial::complete(Frame frame)
{
  for (std::size_t m = filter_ ? 1 : 0; m < methods_.localizers.size(); ++m)
  {
    const auto before = Clock::now();
    const Estimate estimate = methods_.localizers[m]->process(frame);
    run_.methods[m].step_milliseconds.push_back(millisecondsSince(before));
    record(estimate, frame, run_.methods[m]);
    if (&run_.methods[m] == judged_)
      run_.verdicts.add(frame.time, verdictOf(estimate), {});
    else if (!run_.methods[m].continuous)
      oracles_.add(run_.methods[m], estimate, frame.time);
  }
  playback_.add(frame, methods_.filter, run_.playback);
  if (input_.on_frame) input_.on_frame(completed_, frame, methods_.filter);
  ++completed_;
  if (input_.on_progress)
    input_.on_progress(static_cast<double>(completed_) / static_cast<double>(input_.run.log.frames));
  last_ = std::move(frame);
}

void Trial::finish()
{
  if (methods_.filter)
    finishFilter(*methods_.filter, input_, run_);
  else
    setVerdict(verdictOfClosedForms(run_), input_.run.warning, run_);
  if (last_)
    outcome_.final_step =
        playbackStep(*last_, methods_.filter, input_.methods.map(), std::numeric_limits<std::size_t>::max());
}
}  // namespace

TrialOutcome runTrial(const TrialInput& input, std::uint64_t seed, int trial)
{
  return Trial(input, seed, trial).run();
}
}  // namespace mrpt_ext
