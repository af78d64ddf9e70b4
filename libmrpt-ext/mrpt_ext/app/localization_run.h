#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// The options of a run, beside the settings.
struct LocalizationRequest
{
  std::filesystem::path output;  ///< empty: logOutput_dir, else out/<name of the configuration>
  LogWindow window;
  int first_trial = 0, last_trial = 1;  ///< trials first ... last - 1
  bool trial_folders = false;           ///< one sub-folder per trial and a merged summary on top
  int jobs = 1;
  std::optional<double> fail_above;  ///< [m]
  bool gui = false;                  ///< show the first trial in a window
  double gui_speed = 10;             ///< seconds of log per second there
  bool resume = false;               ///< skip the trials that the output folder contains already
  bool dry_run = false, quiet = false, verbose = false;
  std::string command_line;
  std::string note;  ///< one line to print with the input, or empty
};

/// The main job: load, run all trials, score, write, print. Results go to `out`, progress to stderr on a terminal.
/// Returns the exit code of the contract.
int runLocalization(const Settings& settings, const LocalizationRequest& request, std::ostream& out, std::ostream& err);
}  // namespace mrpt_ext
