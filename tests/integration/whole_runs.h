#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext::testing
{
using Arguments = std::vector<std::string>;

/// What an app said and returned.
struct AppOutcome
{
  int exit_code = -1;
  std::string out, err;
};

/// The apps, run in this process.
[[nodiscard]] AppOutcome localize(const Arguments& arguments);
[[nodiscard]] AppOutcome simulate(const Arguments& arguments);
[[nodiscard]] AppOutcome convert(const Arguments& arguments);

/// A shipped configuration, ini/<app>/<name>.ini.
[[nodiscard]] std::filesystem::path shipped(const std::string& app, const std::string& name);

/// A log with its companions, as the simulator and the importers leave them.
struct LogFiles
{
  std::filesystem::path rawlog, map, truth;
  /// RAWLOG, --map and, if there is a truth, --ground-truth for landmark-localization.
  [[nodiscard]] Arguments arguments() const;
};
[[nodiscard]] LogFiles logFiles(const std::filesystem::path& folder, const std::string& stem);

/// Imports a recording: `arguments` of dataset2rawlog are the format, the input and options; a failure is a failure of
/// the test.
LogFiles imported(const std::filesystem::path& folder, const Arguments& arguments);

/// Plays ini/landmark-simulator/<scenario>.ini into `folder`; a failure is a failure of the test.
LogFiles simulated(const std::filesystem::path& folder, const std::string& scenario, const Arguments& more = {});

/// Runs ini/landmark-localization/<name>.ini into `folder`/<name>; expects exit code 0 and silence on stderr. As
/// configured, in one pass: its tests state what the configuration does, test_auto_calibration what the log adds.
std::filesystem::path localized(const std::filesystem::path& folder, const std::string& name,
                                const Arguments& more = {});

/// joined({"a"}, {"b", "c"}) = {"a", "b", "c"}.
[[nodiscard]] Arguments joined(Arguments first, const Arguments& second);

[[nodiscard]] nlohmann::json summaryOf(const std::filesystem::path& run);
/// RMSE of the position after convergence; NaN when it is null.
[[nodiscard]] double positionRmse(const nlohmann::json& summary, const std::string& method = "particle_filter");
[[nodiscard]] double medianPositionError(const nlohmann::json& summary, const std::string& method);

/// A row of steps.csv.
struct StepRow
{
  double time = 0;
  double x = 0, y = 0, phi = 0;               // m, m, rad
  double cxx = 0, cxy = 0, cyy = 0, cpp = 0;  // m^2, rad^2
  int modes = 0;
  std::string verdict;
};
[[nodiscard]] std::vector<StepRow> stepsOf(const std::filesystem::path& run,
                                           const std::string& method = "particle_filter");

/// Distance of a step from the true position at its time; NaN where the truth has no pose.
[[nodiscard]] double positionError(const StepRow& step, const Trajectory& truth);

/// Everything of a run that has to be the same bytes for the same random seed, by path inside the folder.
[[nodiscard]] std::map<std::string, std::string> reproducibleContent(const std::filesystem::path& run);
}  // namespace mrpt_ext::testing
