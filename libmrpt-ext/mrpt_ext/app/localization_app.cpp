#include <charconv>
#include <iostream>
#include <utility>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/calibration_run.h"
#include "mrpt_ext/app/live_run.h"
#include "mrpt_ext/app/localization_run.h"
#include "mrpt_ext/app/log_lines.h"
#include "mrpt_ext/app/shell_quote.h"
#include "mrpt_ext/configuration/configured_files.h"
#include "mrpt_ext/configuration/default_configuration.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{

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

/// The options as given, before they become a request.
struct LocalizationOptions
{
  std::string config, rawlog, map, truth, trials;
  int repeat = 0;
  bool diagnose = false, live = false, lines = false;
  LocalizationRequest request;
  std::filesystem::path calibrated;
};

void addOptions(CommandLine& line, LocalizationOptions& options)
{
  LocalizationRequest& request = options.request;
  line.add({.names = "CONFIG",
            .target = &options.config,
            .help = "Configuration (.ini); a .rawlog in its place runs with a built-in one",
            .required = true})
      .add({.names = "RAWLOG", .target = &options.rawlog, .help = "Log to process instead of the configured one"})
      .add({.names = "--map", .target = &options.map, .help = "Map instead of the configured one"})
      .add({.names = "--ground-truth", .target = &options.truth, .help = "Ground truth instead of the configured one"})
      .add({.names = "--start",
            .target = &request.window.start,
            .help = "Skip the first S seconds of the log",
            .numbers = AllowedNumbers::not_negative})
      .add({.names = "--duration",
            .target = &request.window.duration,
            .help = "Process S seconds of the log only",
            .numbers = AllowedNumbers::positive})
      .add({.names = "--repeat",
            .target = &options.repeat,
            .help = "N independent trials",
            .numbers = AllowedNumbers::positive})
      .add({.names = "--trials",
            .target = &options.trials,
            .help = "A:B: trials A to B-1 of a longer study",
            .excludes = "--repeat"})
      .add({.names = "--jobs",
            .target = &request.jobs,
            .help = "Worker threads in total: trials first, then particle blocks",
            .numbers = AllowedNumbers::positive})
      .add({.names = "--fail-above",
            .target = &request.fail_above,
            .help = "Exit code 3 if the filter's position RMSE exceeds M metres",
            .numbers = AllowedNumbers::positive})
      .add({.names = "--gui", .target = &request.gui, .help = "Show the first trial in a window"})
      .add({.names = "--gui-speed",
            .target = &request.gui_speed,
            .help = "Seconds of log per second in the window; default 10",
            .numbers = AllowedNumbers::positive,
            .needs = "--gui"})
      .add({.names = "--resume",
            .target = &request.resume,
            .help = "Skip the trials that the output folder contains already"})
      .add({.names = "--diagnose",
            .target = &options.diagnose,
            .help = "Estimate sensor and odometry calibration from the log instead of running; print the suggested "
                    ".ini lines"})
      .add({.names = "--examine", .target = &options.diagnose, .help = "--diagnose", .hidden = true})
      .add(
          {.names = "--calibrate",
           .target = &options.calibrated,
           .help = "The same, and write these lines into this configuration (.ini); without CONFIG a new file is made"})
      .add({.names = "--live",
            .target = &options.live,
            .help = "Read measurements as JSON lines from standard input and write estimates as they become final",
            .excludes = "--repeat"})
      .add({.names = "--lines",
            .target = &options.lines,
            .help = "Write the log to standard output as the lines that --live reads",
            .excludes = "--live"})
      .add({.names = "--dry-run", .target = &request.dry_run, .help = "Load and check everything, run nothing"});
}

/// A log in the place of the configuration is the log.
void sortArguments(LocalizationOptions& options)
{
  if (std::filesystem::is_directory(options.config) || std::filesystem::path(options.config).extension() == ".csv")
    throw configurationError(options.config + ": expected an .ini file or a rawlog; `dataset2rawlog csv FOLDER -o " +
                             "STEM.rawlog` makes one of CSV files");
  const bool is_log = std::filesystem::path(options.config).filename().string().find(".rawlog") != std::string::npos;
  if (is_log && options.rawlog.empty()) options.rawlog = std::exchange(options.config, {});
}

Settings configuredSettings(const LocalizationOptions& options, const AppShell& shell)
{
  if (!options.config.empty()) return shell.loadSettings(options.config, localizationKeys());
  return Settings::parse(std::string(defaultConfiguration()), kDefaultConfigurationName, localizationKeys(),
                         shell.options().overrides);
}

/// The configuration with what the command line replaces. Files are absolute: those of an .ini are relative to it.
Settings settingsOf(const LocalizationOptions& options, const AppShell& shell)
{
  Settings settings = configuredSettings(options, shell);
  const auto replace =
      [&](const std::string& file, const std::string& section, const std::string& key, const std::string& option)
  {
    if (!file.empty()) settings.set(section, key, std::filesystem::absolute(file).string(), option + ' ' + file);
  };
  replace(options.rawlog, kExperimentSection, "rawlog_file", "RAWLOG");
  replace(options.truth, kExperimentSection, "ground_truth_path_file", "--ground-truth");
  replace(options.map, kMapSection, "landmarks_file", "--map");
  if (const auto seed = shell.options().seed)
    settings.set(kExperimentSection, "random_seed", std::to_string(*seed), "--seed " + std::to_string(*seed));
  return settings;
}

/// A log with the truth of the configuration, which may be that of another log.
std::string truthNote(const LocalizationOptions& options, const Settings& settings)
{
  if (options.rawlog.empty() || !options.truth.empty() ||
      !settings.hasValue(kExperimentSection, "ground_truth_path_file"))
    return {};
  return "note     the ground truth is the configured one, " +
         settings.path(kExperimentSection, "ground_truth_path_file").string() +
         ": give --ground-truth if it does not belong to this log\n";
}

int runRequest(LocalizationOptions options, AppShell& shell)
{
  sortArguments(options);
  const Settings settings = settingsOf(options, shell);
  LocalizationRequest request = options.request;
  if (options.lines) return writeLogLines(settings, request.window, shell.out(), shell.err());
  if (options.live) return runLive(settings, std::cin, shell.out());
  if (options.diagnose || !options.calibrated.empty())
  {
    // Who has no configuration has no file to write into either.
    const std::string_view initial = options.config.empty() ? defaultConfiguration() : std::string_view();
    return runCalibration(settings, {request.window, options.calibrated, initial, shell.options().quiet}, shell.out());
  }
  const auto repetitions = settings.integer(kExperimentSection, "experimentRepetitions");
  request.last_trial = options.repeat > 0 ? options.repeat : static_cast<int>(repetitions);
  request.trial_folders = options.repeat > 0 || repetitions > 1;
  if (!options.trials.empty()) parseTrials(options.trials, request);
  request.note = truthNote(options, settings);
  request.output = shell.options().output;
  if (options.config.empty() && request.output.empty())
    request.output = std::filesystem::path("out") / std::filesystem::path(options.rawlog).stem();
  request.quiet = shell.options().quiet;
  request.verbose = shell.options().verbose;
  return runLocalization(settings, request, shell.out(), shell.err());
}
}  // namespace

int runLandmarkLocalization(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err)
{
  AppShell shell({.name = "landmark-localization",
                  .purpose = "Localizes a robot from landmarks: particle filter and closed forms over a rawlog",
                  .examples = {"ini/landmark-localization/room.ini -o out/room", "my.rawlog --map my_map.csv",
                               "my.ini my.rawlog --map my_map.csv --repeat 20 --jobs 4"}},
                 out, err);
  shell.answerQuestionsAbout(localizationKeys());
  LocalizationOptions options;
  addOptions(shell.commandLine(), options);
  options.request.command_line = "landmark-localization " + shellLine(arguments);
  return shell.run(arguments, [&] { return runRequest(options, shell); });
}
}  // namespace mrpt_ext
