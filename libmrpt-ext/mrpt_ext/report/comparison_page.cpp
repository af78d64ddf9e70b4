#include "mrpt_ext/report/comparison_page.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/evaluation/rmse_interval.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kErrorNote =
    "Median over the trials of the RMSE from convergence on; below it the 95 % interval of the median (five trials or "
    "more) or the range of the trials. Bold: the lowest of a run, without oracles. A dash: no trial has the number.";

/// Median, and below it its interval.
std::string errorCell(const std::vector<double>& values, bool best)
{
  if (values.empty()) return kNoNumber;
  std::string text = magnitudeText(median(values));
  if (best) text = element("b", "", text);
  const auto interval = medianInterval(values);
  if (interval)
    text += element("small", "", magnitudeText(interval->low) + " – " + magnitudeText(interval->high));
  else if (values.size() > 1)
    text += element("small", "", magnitudeText(quantile(values, 0)) + " … " + magnitudeText(quantile(values, 1)));
  return text;
}

bool isOracle(const std::string& method) { return method.starts_with("oracle_"); }

/// The method with the lowest median of a run.
std::string bestOf(const FinishedRun& run, NumberByMethod FinishedTrial::*rmse)
{
  std::string best;
  double lowest = HUGE_VAL;
  for (const std::string& method : run.methods)
    if (const auto m = median(valuesOf(run, method, rmse)); !isOracle(method) && m && *m < lowest)
    {
      lowest = *m;
      best = method;
    }
  return best;
}

std::string errorTable(const std::vector<FinishedRun>& runs, NumberByMethod FinishedTrial::*rmse)
{
  std::vector<std::string> methods, titles{"method"};
  for (const FinishedRun& run : runs)
  {
    titles.push_back(escapeHtml(run.name));
    for (const std::string& method : run.methods)
      if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
  }
  std::string rows;
  for (const std::string& method : methods)
  {
    std::vector<std::string> cells{keyedName(method, methods)};
    for (const FinishedRun& run : runs)
      cells.push_back(errorCell(valuesOf(run, method, rmse), method == bestOf(run, rmse)));
    rows += htmlRow(cells, isOracle(method) ? "oracle" : "");
  }
  return htmlTable(titles, rows);
}

std::string successRow(const FinishedRun& run)
{
  std::size_t judged = 0, successes = 0, lost = 0, ambiguous = 0;
  const std::vector<double> converged = convergenceTimes(run);
  for (const FinishedTrial& trial : run.trials)
  {
    judged += trial.score.success ? 1 : 0;
    successes += trial.score.success.value_or(false) ? 1 : 0;
    lost += trial.score.verdict == Verdict::lost ? 1 : 0;
    ambiguous += trial.score.verdict == Verdict::ambiguous ? 1 : 0;
  }
  std::string rate = kNoNumber, range = kNoNumber;
  if (judged > 0)
  {
    const auto [low, high] = successInterval(successes, judged);
    rate = std::to_string(successes) + " of " + std::to_string(judged);
    range = percentText(low) + " – " + percentText(high);
  }
  return htmlRow({escapeHtml(run.name), std::to_string(run.trials.size()), rate, range, std::to_string(lost),
                  std::to_string(ambiguous), numberText(median(converged), 1), numberText(quantile(converged, 1), 1)},
                 lost > 0 ? "warned" : "");
}

std::string sourceRow(const FinishedRun& run)
{
  std::string folders;
  for (const std::string& folder : run.folders) folders += (folders.empty() ? "" : ", ") + folder;
  if (run.repeated > 0) folders += " (" + std::to_string(run.repeated) + " trials given twice, counted once)";
  return htmlRow({escapeHtml(run.name), escapeHtml(folders), escapeHtml(run.rawlog_path), escapeHtml(run.rawlog_sha256),
                  escapeHtml(run.version)});
}
}  // namespace

std::pair<double, double> successInterval(std::size_t successes, std::size_t trials)
{
  if (trials == 0) return {0, 1};
  constexpr double kNormal = 1.959964;
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n, z2 = square(kNormal) / n;
  const double centre = (share + z2 / 2) / (1 + z2);
  const double half = std::sqrt(z2 * (share * (1 - share) + z2 / 4)) / (1 + z2);
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

std::string comparisonPage(const std::vector<FinishedRun>& runs)
{
  std::string successes, sources;
  std::size_t trials = 0;
  for (const FinishedRun& run : runs)
  {
    successes += successRow(run);
    sources += sourceRow(run);
    trials += run.trials.size();
  }
  const std::vector<std::string> success_titles{
      "run", "trials", "successes", "95 % interval", "lost", "ambiguous", "converged after s, median", "maximum"};
  return htmlPage(
      "Landmark localization: comparison of runs",
      std::to_string(runs.size()) + " runs, " + std::to_string(trials) + " trials",
      htmlSection("Success", htmlTable(success_titles, successes),
                  "95 % interval of the success probability: Wilson’s score interval.") +
          htmlSection("Position RMSE [m]", errorTable(runs, &FinishedTrial::position_rmse_m), kErrorNote) +
          htmlSection("Heading RMSE [deg]", errorTable(runs, &FinishedTrial::heading_rmse_deg), kErrorNote) +
          htmlSection("Sources", htmlTable({"run", "folders", "log", "log, SHA-256", "version"}, sources),
                      "Folders with the same log and configuration are one run."));
}
}  // namespace mrpt_ext
