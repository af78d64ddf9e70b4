#include "mrpt_ext/report/html_page.h"

#include "mrpt_ext/report/comparison_text.h"
#include "mrpt_ext/report/figure_text.h"
#include "mrpt_ext/report/html_charts.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/style.h"
#include "mrpt_ext/report/svg_map.h"

namespace mrpt_ext
{
namespace
{
const char* verdictSymbol(Verdict verdict)
{
  return verdict == Verdict::ok ? "✓" : verdict == Verdict::ambiguous ? "?" : "✗";
}

std::string fact(const std::string& name, const std::string& value)
{
  return element("div", "fact", element("b", "", escapeHtml(value)) + element("span", "", escapeHtml(name)));
}

std::string keyFacts(const RunContext& context, const RunScore& score)
{
  const MethodScore* best = bestMethod(score);
  std::string facts;
  if (score.trials.size() > 1) facts += fact("success rate", percentText(score.success_rate));
  if (best) facts += fact("least position RMSE: " + best->name, magnitudeText(best->position_error_m.rmse) + " m");
  if (best && best->heading_error_deg.rmse)
    facts += fact("its heading RMSE", figureText(best->heading_error_deg.rmse, 2) + " deg");
  if (score.converged_at_s) facts += fact("until converged", figureText(score.converged_at_s, 1) + " s");
  facts += fact("length of the log", figureText(context.duration_s, 0) + " s");
  if (score.cost.realtime_factor)
    facts += fact("faster than real time", magnitudeText(score.cost.realtime_factor) + " x");
  return element("div", "facts-strip", facts) + "\n";
}

std::string verdictStrip(const RunScore& score)
{
  const std::string verdict = toString(score.verdict);
  std::string html = element("p", "word", element("span", "symbol", verdictSymbol(score.verdict)) + verdict);
  html += element("p", "reason", escapeHtml(score.verdict_reason));
  html += element("p", "", escapeHtml(outcomeText(score)));
  if (score.interrupted) html += element("p", "", "Interrupted: the figures cover only what was finished.");
  return element("section", "verdict " + verdict, "\n" + html) + "\n";
}

/// Nothing when there is nothing to show.
std::string section(const std::string& title, const std::string& content, const std::string& note = "")
{
  if (content.empty()) return {};
  const std::string explanation = note.empty() ? "" : element("p", "note", note) + "\n";
  return element("section", "", element("h2", "", title) + "\n" + content + explanation) + "\n";
}

std::string methodSection(const RunScore& score)
{
  const std::string from = score.judged_method
                               ? "Errors count from the convergence of " + escapeHtml(*score.judged_method) +
                                     " on; “whole run” counts everything. "
                               : "All estimates count. ";
  std::string conclusions;
  if (const std::string limit = limitText(score); !limit.empty()) conclusions += element("li", "", escapeHtml(limit));
  for (const std::string& sentence : comparisonSentences(score)) conclusions += element("li", "", escapeHtml(sentence));
  if (!conclusions.empty()) conclusions = element("ul", "", conclusions) + "\n";
  return section("Methods side by side", methodTable(score) + conclusions,
                 from + "All methods are judged at the same stamps. A dash: the figure does not exist.");
}

std::string commonSections(const RunContext& context, const RunScore& score)
{
  return section("Landmarks", landmarkTable(score), "Residuals of the inliers in units of their standard deviation.") +
         section("Filter", filterTable(score)) + section("Observations", observationTable(context)) +
         section("How to repeat this run", provenanceTable(context, score));
}

std::string nameOf(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.empty() ? "run" : name;
}

std::string page(const RunContext& context, const RunScore& score, const std::string& subtitle,
                 const std::string& sections)
{
  const std::string title = "Landmark localization: " + escapeHtml(nameOf(context.config_path));
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n" +
      element("title", "", title) + "\n" + element("style", "", "\n" + std::string(reportStyle()));
  const std::string header =
      element("header", "", element("h1", "", title) + element("p", "note", escapeHtml(subtitle))) + "\n";
  const std::string body = header + verdictStrip(score) + keyFacts(context, score) + sections;
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("head", "", "\n" + head + "\n") + "\n" +
         element("body", "", "\n" + element("main", "", "\n" + body)) + "\n</html>\n";
}
}  // namespace

std::string trialPage(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const std::string subtitle =
      nameOf(context.rawlog_path) + ", trial " + std::to_string(record.trial) + ", seed " + std::to_string(record.seed);
  return page(context, score, subtitle,
              methodSection(score) + section("Map", svgMap(context, record, score)) +
                  section("Position error over time", positionErrorChart(context, score),
                          "The dashed line is the limit that counts as converged.") +
                  section("Heading error over time", headingErrorChart(context, score)) +
                  section("The filter’s own confidence", confidenceChart(context, record, score)) +
                  commonSections(context, score));
}

std::string mergedPage(const RunContext& context, const RunScore& merged)
{
  const std::string subtitle = nameOf(context.rawlog_path) + ", " + std::to_string(merged.trials.size()) + " trials";
  return page(context, merged, subtitle,
              section("Trials", trialTable(merged)) + methodSection(merged) + commonSections(context, merged));
}
}  // namespace mrpt_ext
