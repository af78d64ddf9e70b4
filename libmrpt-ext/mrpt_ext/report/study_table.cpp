#include "mrpt_ext/report/study_table.h"

#include <algorithm>
#include <set>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/report/csv_field.h"

namespace mrpt_ext
{
namespace
{
std::string text(const OptionalNumber& number, int decimals, const std::string& none)
{
  return number ? fixedText(*number, decimals) : none;
}

/// Name, log, method, trials, successes, lost, converged, RMSE, median, 95 %, heading RMSE, share of `ok` and coverage
/// of a method.
std::vector<std::string> cellsOf(const FinishedRun& run, const std::string& method, const std::string& none)
{
  const auto median_of = [&](NumberByMethod FinishedTrial::*number) { return median(valuesOf(run, method, number)); };
  const auto count = [&](auto&& is_counted)
  { return std::to_string(std::count_if(run.trials.begin(), run.trials.end(), is_counted)); };
  return {run.name,
          std::filesystem::path(run.rawlog_path).stem().string(),
          method,
          std::to_string(run.trials.size()),
          count([](const FinishedTrial& trial) { return trial.score.success.value_or(false); }),
          count([](const FinishedTrial& trial) { return trial.score.verdict == Verdict::lost; }),
          text(median(convergenceTimes(run)), 1, none),
          text(median_of(&FinishedTrial::position_rmse_m), 3, none),
          text(median_of(&FinishedTrial::position_median_m), 3, none),
          text(median_of(&FinishedTrial::position_p95_m), 3, none),
          text(median_of(&FinishedTrial::heading_rmse_deg), 2, none),
          text(median_of(&FinishedTrial::ok_share), 3, none),
          text(median_of(&FinishedTrial::coverage_95), 3, none)};
}

/// Methods with an error, and the filter, whose successes are counted: a study that fails has its row too.
std::vector<std::string> judgedMethods(const FinishedRun& run)
{
  std::vector<std::string> judged;
  for (const std::string& method : run.methods)
    if (method == "particle_filter" || !valuesOf(run, method, &FinishedTrial::position_rmse_m).empty())
      judged.push_back(method);
  return judged;
}

/// Names of the settings that are not the same in all runs.
std::vector<std::string> varied(const std::vector<FinishedRun>& runs)
{
  std::map<std::string, std::set<std::string>> values;
  for (const FinishedRun& run : runs)
    for (const auto& [name, value] : run.settings) values[name].insert(value);
  std::vector<std::string> names;
  for (const auto& [name, seen] : values)
    if (seen.size() > 1) names.push_back(name);
  return names;
}
}  // namespace

std::string studyMarkdown(const std::vector<FinishedRun>& runs)
{
  std::string table =
      "| run | log | method | trials | successes | lost | converged after s | RMSE m | median m | 95 % m | heading "
      "RMSE deg | `ok` | truth in 95 % region |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const FinishedRun& run : runs)
    for (const std::string& method : judgedMethods(run))
    {
      for (const std::string& cell : cellsOf(run, method, "-")) table += "| " + cell + " ";
      table += "|\n";
    }
  return table;
}

std::string studyCsv(const std::vector<FinishedRun>& runs)
{
  const std::vector<std::string> settings = varied(runs);
  std::string table;
  for (const std::string& name : settings) table += textField(name) + ",";
  table +=
      "run,log,method,trials,successes,lost,converged_s,rmse_m,median_m,p95_m,heading_rmse_deg,ok_share,coverage_95\n";
  for (const FinishedRun& run : runs)
    for (const std::string& method : judgedMethods(run))
    {
      std::string row;
      for (const std::string& name : settings)
      {
        const auto found = run.settings.find(name);
        row += (found == run.settings.end() ? "" : textField(found->second)) + ",";
      }
      for (const std::string& cell : cellsOf(run, method, "")) row += textField(cell) + ",";
      row.back() = '\n';
      table += row;
    }
  return table;
}
}  // namespace mrpt_ext
