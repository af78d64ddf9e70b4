#include "mrpt_ext/report/comparison_page.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/evaluation/rmse_interval.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/page_assets.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kErrorNote =
    "Median over the trials of the RMSE from convergence on; below it the 95 % interval of the median (five trials or "
    "more) or the spread from the least to the largest. Bold: the least of a run, oracles left out. A dash: no trial "
    "has the figure.";

using RmseByMethod = std::map<std::string, OptionalNumber> FinishedTrial::*;

std::string cell(const std::string& html) { return element("td", "", html); }
std::string rowHead(const std::string& html) { return "<th scope=\"row\">" + html + "</th>"; }

std::string table(const std::vector<std::string>& titles, const std::string& rows)
{
  std::string head;
  for (const std::string& title : titles) head += "<th scope=\"col\">" + escapeHtml(title) + "</th>";
  const std::string body = element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", "\n" + rows);
  return element("div", "scroll", element("table", "", "\n" + body)) + "\n";
}

std::vector<double> valuesOf(const FinishedRun& run, const std::string& method, RmseByMethod figures)
{
  std::vector<double> values;
  for (const FinishedTrial& trial : run.trials)
    if (const auto found = (trial.*figures).find(method); found != (trial.*figures).end() && found->second)
      values.push_back(*found->second);
  return values;
}

/// Median, and below it how sure it is.
std::string errorCell(const std::vector<double>& values, bool best)
{
  if (values.empty()) return cell(kNoNumber);
  std::string text = magnitudeText(median(values));
  if (best) text = element("b", "", text);
  const auto interval = medianInterval(values);
  if (interval)
    text += element("small", "", magnitudeText(interval->low) + " – " + magnitudeText(interval->high));
  else if (values.size() > 1)
    text += element("small", "", magnitudeText(quantile(values, 0)) + " … " + magnitudeText(quantile(values, 1)));
  return cell(text);
}

bool isOracle(const std::string& method) { return method.starts_with("oracle_"); }

/// The method with the least median in this run.
std::string bestOf(const FinishedRun& run, RmseByMethod figures)
{
  std::string best;
  double least = HUGE_VAL;
  for (const std::string& method : run.methods)
    if (const auto m = median(valuesOf(run, method, figures)); !isOracle(method) && m && *m < least)
    {
      least = *m;
      best = method;
    }
  return best;
}

std::string errorTable(const std::vector<FinishedRun>& runs, RmseByMethod figures)
{
  std::vector<std::string> methods, titles{"method"};
  for (const FinishedRun& run : runs)
  {
    titles.push_back(run.name);
    for (const std::string& method : run.methods)
      if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
  }
  std::string rows;
  for (const std::string& method : methods)
  {
    std::string row = rowHead(element("span", "key dot " + methodClass(method, methods), "") + breakableName(method));
    for (const FinishedRun& run : runs)
      row += errorCell(valuesOf(run, method, figures), method == bestOf(run, figures));
    rows += element("tr", isOracle(method) ? "oracle" : "", row) + "\n";
  }
  return table(titles, rows);
}

std::string successRow(const FinishedRun& run)
{
  std::size_t judged = 0, successes = 0, lost = 0, ambiguous = 0;
  std::vector<double> converged;
  for (const FinishedTrial& trial : run.trials)
  {
    judged += trial.score.success ? 1 : 0;
    successes += trial.score.success.value_or(false) ? 1 : 0;
    lost += trial.score.verdict == Verdict::lost ? 1 : 0;
    ambiguous += trial.score.verdict == Verdict::ambiguous ? 1 : 0;
    if (trial.score.converged_at_s) converged.push_back(*trial.score.converged_at_s);
  }
  std::string rate = kNoNumber, range = kNoNumber;
  if (judged > 0)
  {
    const auto [low, high] = successInterval(successes, judged);
    rate = std::to_string(successes) + " of " + std::to_string(judged);
    range = percentText(low) + " – " + percentText(high);
  }
  return element("tr", lost > 0 ? "doubtful" : "",
                 rowHead(escapeHtml(run.name)) + cell(std::to_string(run.trials.size())) + cell(rate) + cell(range) +
                     cell(std::to_string(lost)) + cell(std::to_string(ambiguous)) +
                     cell(numberText(median(converged), 1)) + cell(numberText(quantile(converged, 1), 1))) +
         "\n";
}

std::string sourceRow(const FinishedRun& run)
{
  std::string folders;
  for (const std::string& folder : run.folders) folders += (folders.empty() ? "" : ", ") + folder;
  if (run.repeated > 0) folders += " (" + std::to_string(run.repeated) + " trials given twice, counted once)";
  return element("tr", "",
                 rowHead(escapeHtml(run.name)) + cell(escapeHtml(folders)) + cell(escapeHtml(run.rawlog_path)) +
                     cell(escapeHtml(run.rawlog_sha256)) + cell(escapeHtml(run.version))) +
         "\n";
}

std::string section(const std::string& title, const std::string& content, const std::string& note)
{
  return element("section", "", element("h2", "", title) + "\n" + content + element("p", "note", note)) + "\n";
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
  const std::string title = "Landmark localization: runs side by side";
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n" +
      element("title", "", title) + "\n" + element("style", "", "\n" + std::string(pageStyle()));
  const std::string subtitle = std::to_string(runs.size()) + " runs, " + std::to_string(trials) + " trials";
  const std::string body =
      element("header", "", element("h1", "", title) + element("p", "note", subtitle)) + "\n" +
      section("Success",
              table({"run", "trials", "successes", "95 % interval", "lost", "ambiguous", "converged after s, median",
                     "... at most"},
                    successes),
              "The interval is Wilson’s, for the chance of success.") +
      section("Position RMSE [m]", errorTable(runs, &FinishedTrial::position_rmse_m), kErrorNote) +
      section("Heading RMSE [deg]", errorTable(runs, &FinishedTrial::heading_rmse_deg), kErrorNote) +
      section("Where it comes from", table({"run", "folders", "log", "log, SHA-256", "version"}, sources),
              "Folders with the same log and configuration are one run.");
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("head", "", "\n" + head + "\n") + "\n" +
         element("body", "", "\n" + element("main", "", "\n" + body)) + "\n</html>\n";
}
}  // namespace mrpt_ext
