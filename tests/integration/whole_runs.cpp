#include "whole_runs.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/maps/register_all_classes.h"

namespace mrpt_ext::testing
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

AppOutcome runApp(int (*app)(const Arguments&, std::ostream&, std::ostream&), const Arguments& arguments)
{
  registerAllClasses();
  std::ostringstream out, err;
  const int exit_code = app(arguments, out, err);
  return {exit_code, out.str(), err.str()};
}

double numberOrNan(const Json& value)
{
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// The summary without what depends on the machine's speed.
std::string timelessSummary(const fs::path& file)
{
  Json summary = Json::parse(readTextFile(file));
  summary.erase("cost");
  summary.erase("time_per_step_ms");
  for (Json& method : summary["methods"]) method.erase("time_per_step_ms");
  return summary.dump();
}
}  // namespace

AppOutcome localize(const Arguments& arguments) { return runApp(runLandmarkLocalization, arguments); }
AppOutcome simulate(const Arguments& arguments) { return runApp(runLandmarkSimulator, arguments); }
AppOutcome convert(const Arguments& arguments) { return runApp(runDataset2Rawlog, arguments); }

fs::path shipped(const std::string& app, const std::string& name)
{
  return fs::path(MRPT_EXT_SOURCE_DIR) / "ini" / app / (name + ".ini");
}

Arguments LogFiles::arguments() const
{
  return truth.empty() ? Arguments{rawlog, "--map", map} : Arguments{rawlog, "--map", map, "--ground-truth", truth};
}

LogFiles logFiles(const fs::path& folder, const std::string& stem)
{
  return {folder / (stem + ".rawlog"), folder / (stem + "_map.csv"), folder / (stem + "_ground_truth.tum")};
}

LogFiles imported(const fs::path& folder, const Arguments& arguments)
{
  const LogFiles files = logFiles(folder, "log");
  const AppOutcome outcome = convert(joined(arguments, {"-q", "-o", files.rawlog}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return files;
}

LogFiles simulated(const fs::path& folder, const std::string& scenario, const Arguments& more)
{
  const LogFiles files = logFiles(folder, scenario);
  const AppOutcome outcome =
      simulate(joined({shipped("landmark-simulator", scenario), "-q", "-o", files.rawlog}, more));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return files;
}

fs::path localized(const fs::path& folder, const std::string& name, const Arguments& more)
{
  const fs::path run = folder / name;
  const Arguments once{
      shipped("landmark-localization", name), "--set", "LocalizationExperiment.auto_calibrate=false", "-q", "-o", run};
  const AppOutcome outcome = localize(joined(once, more));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  EXPECT_EQ(outcome.err, "");
  return run;
}

Arguments joined(Arguments first, const Arguments& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Json summaryOf(const fs::path& run) { return Json::parse(readTextFile(run / "summary.json")); }

double positionRmse(const Json& summary, const std::string& method)
{
  return numberOrNan(summary.at("methods").at(method).at("position_error_m").at("rmse"));
}

double medianPositionError(const Json& summary, const std::string& method)
{
  return numberOrNan(summary.at("methods").at(method).at("position_error_m").at("median"));
}

std::vector<StepRow> stepsOf(const fs::path& run, const std::string& method)
{
  const TextTable table(run / "steps.csv", {});
  const auto number = [&](std::size_t row, const char* column)
  { return table.optionalNumber(row, table.column(column)).value_or(std::numeric_limits<double>::quiet_NaN()); };
  std::vector<StepRow> steps;
  for (std::size_t row = 0; row < table.size(); ++row)
    if (table.text(row, table.column("method")) == method)
      steps.push_back({number(row, "t"), number(row, "x"), number(row, "y"), degToRad(number(row, "phi_deg")),
                       number(row, "cxx"), number(row, "cxy"), number(row, "cyy"), number(row, "cpp"),
                       table.integer(row, table.column("modes")), table.text(row, table.column("verdict"))});
  return steps;
}

double positionError(const StepRow& step, const Trajectory& truth)
{
  const auto there = interpolate(truth, step.time, 0.5);
  if (!there) return std::numeric_limits<double>::quiet_NaN();
  return std::hypot(step.x - there->pose.x, step.y - there->pose.y);
}

std::map<std::string, std::string> reproducibleContent(const fs::path& run)
{
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(run))
  {
    const fs::path& file = entry.path();
    const std::string name = fs::relative(file, run).string();
    if (file.filename() == "summary.json")
      content[name] = timelessSummary(file);
    else if (file.extension() == ".tum" || file.extension() == ".csv" || file.filename() == "config_resolved.ini")
      content[name] = readTextFile(file);
  }
  return content;
}
}  // namespace mrpt_ext::testing
