#include "mrpt_ext/app/localization_run.h"

#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <mutex>
#include <ostream>
#include <set>

#include "mrpt_ext/app/auto_calibration.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/app/interrupt.h"
#include "mrpt_ext/app/progress_line.h"
#include "mrpt_ext/app/run_summary_text.h"
#include "mrpt_ext/app/version.h"
#include "mrpt_ext/diagnosis/self_diagnosis.h"
#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/experiment/clock_check.h"
#include "mrpt_ext/experiment/frame_bounds.h"
#include "mrpt_ext/experiment/tracking_bound.h"
#include "mrpt_ext/experiment/trial_pool.h"
#include "mrpt_ext/experiment/trial_runner.h"
#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/folder_lock.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/rawlog/sha256.h"
#include "mrpt_ext/report/calibration_text.h"
#include "mrpt_ext/report/comparison_table.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/run_writer.h"
#include "mrpt_ext/report/summary_reader.h"
#include "mrpt_ext/scene/live_view.h"
#include "mrpt_ext/scene/playback_recorder.h"
#include "mrpt_ext/scene/run_scene.h"

namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;
constexpr std::size_t kShownParticles = 2000;

fs::path outputFolder(const Settings& settings, const LocalizationRequest& request)
{
  if (!request.output.empty()) return request.output;
  if (settings.hasValue(kExperimentSection, "logOutput_dir")) return settings.path(kExperimentSection, "logOutput_dir");
  return fs::path("out") / settings.file().stem();
}

void createFolder(const fs::path& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw dataError(folder.string() + ": cannot create the folder: " + error.message());
}

double peakMemoryMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Adds what a summary does not contain about its methods and its truth.
void complete(RunScore& score, const Methods& methods, const RunContext& context)
{
  for (MethodScore& method : score.methods)
    for (const auto& known : methods.localizers)
      if (known->name() == method.name) method.continuous = known->continuous();
  score.truth_stamps = scoringStamps(context).size();
  score.truth_is_sparse = context.truth_is_sparse;
}

/// What config_resolved.ini holds: all that determines the results, but the contents of other files and the seed.
std::string resolvedConfiguration(const Settings& settings, const LogWindow& window)
{
  std::string text = settings.resolvedText();
  if (window.start > 0) text += "; --start " + shortestText(window.start) + "\n";
  if (window.duration) text += "; --duration " + shortestText(*window.duration) + "\n";
  return text;
}

/// A folder with results of other settings must not become a mixture.
void expectSameSettings(const fs::path& folder, const std::string& resolved)
{
  const fs::path file = folder / "config_resolved.ini";
  if (fs::exists(file) && readTextFile(file) != resolved)
    throw configurationError("--resume: " + file.string() +
                             " has other settings, expected the same ones, or -o with another folder");
}

/// A line about trials of other runs in the folder; empty without any.
std::string otherTrialsText(const fs::path& folder, const LocalizationRequest& request)
{
  std::set<std::string> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename().string();
        name.starts_with("trial_") && fs::exists(entry.path() / "summary.json"))
      others.insert(name);
  for (int trial = request.first_trial; request.trial_folders && trial < request.last_trial; ++trial)
    others.erase(trialFolder(trial));
  if (others.empty()) return {};
  return "note     " + folder.string() + " holds " + std::to_string(others.size()) + " more trial" +
         (others.size() > 1 ? "s" : "") + " of earlier runs (" + *others.begin() + (others.size() > 1 ? " ..." : "") +
         "), which localization-report counts as well\n";
}

/// Runs, scores and writes the trials; keeps what the merged report needs.
class TrialBatch
{
 public:
  TrialBatch(const LocalizationInput& input, const LocalizationRequest& request, fs::path folder, std::uint64_t seed,
             LiveView* view)
      : input_(input),
        request_(request),
        view_(view),
        methods_(input.config, input.context.map, input.log.available, &DeferredInterrupt::flag()),
        folder_(std::move(folder)),
        seed_(seed)
  {
    const int count = request.last_trial - request.first_trial;
    scores_.resize(static_cast<std::size_t>(count));
    texts_.resize(scores_.size());
    if (input.config.frames.independent)
      bound_ = boundOfFrames(streamOf(input), input.context.map, input.context.truth, BoundOf::everything);
    else
      tracking_bound_ = trackingBound(input.context, input.config.filter, input.log.overview.odometry, streamOf(input));
  }

  void run()
  {
    const DeferredInterrupt interrupt;
    ProgressLine line(!request_.quiet, "localizing");
    const auto threads = static_cast<unsigned>(std::min(request_.jobs, request_.last_trial - request_.first_trial));
    runTrials(request_.first_trial, request_.last_trial, threads,
              [&](int trial)
              {
                if (!interrupt.flag() && !takeFinished(trial)) runOne(trial, interrupt.flag(), line);
              });
    interrupted_ = interrupt.flag();
  }

  /// The scores of the trials that were run.
  [[nodiscard]] std::vector<RunScore> scores() const
  {
    std::vector<RunScore> done;
    for (const auto& score : scores_)
      if (score) done.push_back(*score);
    return done;
  }
  [[nodiscard]] const std::string& firstText() const { return texts_.front(); }
  [[nodiscard]] bool interrupted() const { return interrupted_; }
  /// Trials that an earlier run had finished.
  [[nodiscard]] std::size_t resumed() const { return resumed_; }

 private:
  /// From convergence on, like the errors that it is compared with.
  [[nodiscard]] LimitScore limitOf(const RunScore& score) const
  {
    if (!score.judged_method || !score.converged_at_s) return {.why_none = tracking_bound_.why_none};
    return limitFrom(tracking_bound_, input_.context.start_time + *score.converged_at_s);
  }

  /// In the window, and as a file if configured.
  void show(std::size_t number, const Frame& frame, const FilterLocalizer* filter, const fs::path& folder, bool first)
  {
    const LandmarkTable& map = input_.context.map;
    if (first && view_ && view_->isOpen()) view_->show(playbackStep(frame, filter, map, kShownParticles));
    const std::size_t every = input_.config.scene_every;
    if (every == 0 || number % every != 0) return;
    createFolder(folder / "scenes");
    char name[32];
    std::snprintf(name, sizeof(name), "%06zu.3Dscene", number);
    writeScene(folder / "scenes" / name, map, playbackStep(frame, filter, map, kShownParticles));
  }

  [[nodiscard]] std::size_t indexOf(int trial) const { return static_cast<std::size_t>(trial - request_.first_trial); }
  [[nodiscard]] fs::path folderOf(int trial) const
  {
    return request_.trial_folders ? folder_ / trialFolder(trial) : folder_;
  }

  /// True when the folder contains the trial already; its score is read from its summary.
  bool takeFinished(int trial)
  {
    if (!request_.resume) return false;
    auto score = readTrialScore(folderOf(trial), input_.context, trial);
    if (!score) return false;
    complete(*score, methods_.make(seed_, trial), input_.context);
    score->limits = input_.config.limits;
    score->limit.why_none = tracking_bound_.why_none;
    const std::lock_guard lock(mutex_);
    scores_[indexOf(trial)] = std::move(score);
    ++done_;
    ++resumed_;
    return true;
  }

  void runOne(int trial, const std::atomic<bool>& stop, ProgressLine& line)
  {
    const std::size_t index = indexOf(trial);
    const auto progress = [&, total = static_cast<double>(scores_.size())](double share)
    {
      const std::lock_guard lock(mutex_);
      line.show((static_cast<double>(done_) + share) / total);
    };
    const fs::path folder = folderOf(trial);
    SelfDiagnosis diagnosis(input_);
    const auto watch = [&](std::size_t number, const Frame& frame, const FilterLocalizer* filter)
    {
      show(number, frame, filter, folder, trial == request_.first_trial);
      if (filter) diagnosis.add(frame, *filter);
    };
    TrialOutcome outcome = runTrial({methods_, input_, stop, progress, watch}, seed_, trial);
    outcome.record.hints = diagnosis.hints(outcome.record.landmarks);
    outcome.record.peak_memory_mb = peakMemoryMegabytes();
    RunScore score = scoreRun(input_.context, outcome.record, input_.config.limits);
    if (outcome.record.interrupted) score.verdict_reason = kInterruptedReason + ("; " + score.verdict_reason);
    if (bound_) score.limit = {bound_->position_rmse, bound_->heading_rmse_deg, {}};
    if (!input_.config.frames.independent) score.limit = limitOf(score);
    createFolder(folder);
    std::string text = ambiguityText(outcome.record, input_.context.start_time);
    if (request_.verbose) text += verdictText(outcome.record, input_.context.start_time);
    writeTrial(folder, input_.context, std::move(outcome.record), score);
    if (input_.config.final_scene) writeScene(folder / "final.3Dscene", input_.context.map, outcome.final_step);
    for (MethodScore& method : score.methods) method.errors.clear();
    const std::lock_guard lock(mutex_);
    texts_[index] = std::move(text);
    scores_[index] = std::move(score);
    ++done_;
  }

  const LocalizationInput& input_;
  const LocalizationRequest& request_;
  LiveView* view_;
  MethodFactory methods_;
  fs::path folder_;
  std::uint64_t seed_;
  std::vector<std::optional<RunScore>> scores_;
  std::vector<std::string> texts_;
  std::optional<FrameBound> bound_;  // of frames that are solved one by one
  TrackingBound tracking_bound_;     // of a robot that moves
  std::mutex mutex_;
  std::size_t done_ = 0, resumed_ = 0;
  bool interrupted_ = false;
};

int exitCode(const RunScore& score, const std::vector<RunScore>& trials, const LocalizationRequest& request,
             bool interrupted, std::ostream& err)
{
  if (interrupted)
  {
    err << "interrupted: finished trials are complete, unfinished ones end here\n";
    return kExitFailed;
  }
  for (const RunScore& trial : trials)
    if (trial.verdict == Verdict::lost) return kExitLost;
  if (!request.fail_above) return kExitDone;
  const MethodScore* judged = judgedScore(score);
  if (judged && judged->position_error_m.rmse.value_or(*request.fail_above + 1) <= *request.fail_above)
    return kExitDone;
  err << "--fail-above: the position RMSE exceeds the limit, or there is none\n";
  return kExitLost;
}

LocalizationInput loaded(const Settings& settings, const LocalizationRequest& request)
{
  LocalizationInput input = loadLocalization(settings, request.window);
  checkClocks(input);
  // Threads that the trials leave over score particle blocks.
  const int trials = request.last_trial - request.first_trial;
  input.config.filter.threads = static_cast<unsigned>(std::max(1, request.jobs / std::min(request.jobs, trials)));
  input.context.version = version();
  input.context.built_with = builtWith();
  input.context.command_line = request.command_line;
  return input;
}

/// Replaces the input by a calibrated one, where its log shows what to change.
void adoptCalibration(LocalizationInput& input, const Settings& settings, const LocalizationRequest& request,
                      const fs::path& folder)
{
  const fs::path file = folder / "calibration.ini";
  fs::remove(file);  // of an earlier run
  const auto calibration = autoCalibration(settings, input, !request.quiet);
  if (!calibration) return;
  writeFileAtomically(file, calibrationIni(calibration->adopted));
  input = loaded(calibration->settings, request);
  input.context.calibration = calibration->adopted;
}
}  // namespace

int runLocalization(const Settings& settings, const LocalizationRequest& request, std::ostream& out, std::ostream& err)
{
  LocalizationInput input = loaded(settings, request);
  const std::string head = inputText(input) + request.note;
  if (!request.quiet) out << head << std::flush;
  if (request.dry_run) return kExitDone;

  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.jobs));

  const fs::path folder = outputFolder(settings, request);
  createFolder(folder);
  const FolderLock lock(folder);
  const std::string resolved = resolvedConfiguration(settings, request.window);
  if (request.resume) expectSameSettings(folder, resolved);
  writeFileAtomically(folder / "config_resolved.ini", resolved);
  if (isAutoCalibrated(input)) adoptCalibration(input, settings, request, folder);
  input.context.settings_sha256 = sha256OfText(resolved);
  const std::uint64_t seed = input.config.seed;
  input.context.seed = seed;
  input.context.objects_wanted = !input.config.frames.object_categories.empty();
  std::optional<LiveView> view;
  if (request.gui) view.emplace(input.context.map, request.gui_speed, err);
  TrialBatch batch(input, request, folder, seed, view ? &*view : nullptr);
  batch.run();

  const std::vector<RunScore> scores = batch.scores();
  if (scores.empty()) return exitCode({}, scores, request, true, err);
  const RunScore merged = mergeScores(scores);
  if (request.trial_folders) writeMerged(folder, input.context, merged);
  const std::string table = calibrationText(input.context, merged) + comparisonTable(merged);
  const std::string tail = (input.config.frames.independent ? boundText(input) : batch.firstText()) + "\n" + table;
  writeFileAtomically(folder / "log.txt", input.context.command_line + "\n" + head + tail);
  if (batch.resumed() > 0 && !request.quiet)
    out << "resumed  " << batch.resumed() << " of " << request.last_trial - request.first_trial
        << " trials were finished already\n";
  if (!request.quiet) out << otherTrialsText(folder, request);
  out << (request.quiet ? table : tail) << "report   " << (folder / "report.html").string() << '\n';
  const int code = exitCode(merged, scores, request, batch.interrupted(), err);
  if (view && view->isOpen() && isatty(STDERR_FILENO) == 1)
  {
    err << "End of the log: close the window to leave.\n";
    view->waitUntilClosed();
  }
  return code;
}
}  // namespace mrpt_ext
