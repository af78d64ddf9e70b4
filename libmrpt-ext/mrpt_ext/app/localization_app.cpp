#include "mrpt_ext/app/localization_app.h"

#include <charconv>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/calibration_run.h"
#include "mrpt_ext/app/localization_run.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
const std::string kExperiment = "LocalizationExperiment";

/// "A:B" -> trials A ... B-1.
void parseTrials(const std::string& text, LocalizationRequest& request)
{
  const auto colon = text.find(':');
  int first = 0, last = 0;
  const auto parse = [](std::string_view digits, int& value)
  {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  const bool numbers = colon != std::string::npos && parse(std::string_view(text).substr(0, colon), first) &&
                       parse(std::string_view(text).substr(colon + 1), last);
  if (!numbers || first < 0 || last <= first)
    throw configurationError("--trials " + text + ": expected A:B with 0 <= A < B, trials A to B-1");
  request.first_trial = first;
  request.last_trial = last;
  request.trial_folders = true;
}

/// The options as the user wrote them, for the report.
std::string commandLine(const std::vector<std::string>& arguments)
{
  std::string line = "landmark-localization";
  for (const std::string& argument : arguments)
    line += argument.find(' ') == std::string::npos ? " " + argument : " '" + argument + "'";
  return line;
}
}  // namespace

int LocalizationApp::run(const std::vector<std::string>& arguments)
{
  AppShell shell("landmark-localization",
                 "Localizes a robot from landmarks: particle filter and closed forms over a rawlog", out_, err_);
  shell.answerQuestionsAbout(localizationKeys());
  std::string config, rawlog, map, truth, trials;
  int repeat = 0;
  double duration = 0;
  LocalizationRequest request;
  CLI::App& cli = shell.cli();
  cli.add_option("CONFIG", config, "Configuration (.ini)")->required();
  cli.add_option("RAWLOG", rawlog, "Log to run over instead of the configured one");
  cli.add_option("--map", map, "Map instead of the configured one");
  cli.add_option("--ground-truth", truth, "Truth instead of the configured one");
  cli.add_option("--start", request.window.start, "Leave out the first S seconds of the log")
      ->check(nonNegativeNumber());
  const CLI::Option* with_duration =
      cli.add_option("--duration", duration, "Use S seconds of the log only")->check(positiveNumber());
  CLI::Option* with_repeat = cli.add_option("--repeat", repeat, "N independent trials")->check(positiveNumber());
  cli.add_option("--trials", trials, "A:B: trials A to B-1 of a longer study")->excludes(with_repeat);
  cli.add_option("--jobs", request.jobs, "Worker threads in total: trials first, then particle blocks")
      ->check(positiveNumber());
  cli.add_option("--fail-above", request.fail_above, "Exit code 3 when the filter's position RMSE exceeds M metres")
      ->check(positiveNumber());
  CLI::Option* gui = cli.add_flag("--gui", request.gui, "Watch the first trial in a window");
  cli.add_option("--gui-speed", request.gui_speed, "Seconds of log per second in the window; default 10")
      ->check(positiveNumber())
      ->needs(gui);
  cli.add_flag("--resume", request.resume, "Leave out the trials that the output folder holds already");
  ExaminationRequest examination;
  bool examine = false;
  cli.add_flag("--examine", examine,
               "Tell what the log says about its sensors and its odometry, and which lines of an .ini follow; no run");
  cli.add_option("--calibrate", examination.calibrated, "Also write these lines into this configuration (.ini)");
  cli.add_flag("--dry-run", request.dry_run, "Load and check everything, run nothing");

  return shell.run(arguments,
                   [&]
                   {
                     const CommonOptions& common = shell.options();
                     Settings settings = Settings::load(config, localizationKeys(), common.overrides);
                     const auto give = [&](const std::string& value, const std::string& section, const std::string& key,
                                           const std::string& option)
                     {
                       if (!value.empty())
                         settings.set(section, key, std::filesystem::absolute(value).string(), option);
                     };
                     const bool other_log =
                         !rawlog.empty() && truth.empty() && settings.hasValue(kExperiment, "ground_truth_path_file");
                     if (other_log)
                       request.note = "note     the truth is that of the configuration, " +
                                      settings.path(kExperiment, "ground_truth_path_file").string() +
                                      ": give --ground-truth if it does not belong to this log\n";
                     give(rawlog, kExperiment, "rawlog_file", "RAWLOG");
                     give(truth, kExperiment, "ground_truth_path_file", "--ground-truth");
                     give(map, "MetricMap_landmarkMap2D_00_creationOpts", "landmarks_file", "--map");
                     if (common.seed) settings.set(kExperiment, "random_seed", std::to_string(*common.seed), "--seed");
                     const auto repetitions = settings.integer(kExperiment, "experimentRepetitions");
                     request.last_trial = repeat > 0 ? repeat : static_cast<int>(repetitions);
                     request.trial_folders = repeat > 0 || repetitions > 1;
                     if (!trials.empty()) parseTrials(trials, request);
                     if (with_duration->count() > 0) request.window.duration = duration;
                     if (examine || !examination.calibrated.empty())
                     {
                       examination.window = request.window;
                       examination.quiet = common.quiet;
                       return runExamination(settings, examination, out_);
                     }
                     request.output = common.output;
                     request.quiet = common.quiet;
                     request.verbose = common.verbose;
                     request.command_line = commandLine(arguments);
                     return runLocalization(settings, request, out_, err_);
                   });
}
}  // namespace mrpt_ext
