#include "mrpt_ext/report/html_page.h"

#include "mrpt_ext/report/comparison_text.h"
#include "mrpt_ext/report/html_charts.h"
#include "mrpt_ext/report/html_geometry.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/page_assets.h"
#include "mrpt_ext/report/page_data.h"
#include "mrpt_ext/report/residual_chart.h"
#include "mrpt_ext/report/svg_map.h"

namespace mrpt_ext
{
namespace
{
/// The page may show and run what is in it, and ask for nothing.
constexpr const char* kOffline = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

constexpr const char* kIntervalNote =
    "The interval holds 95 % of resamples: of blocks of ten neighbouring stamps within a trial, of trials in a merged "
    "report. ";
constexpr const char* kNeesNote =
    "Squared error in units of the covariance that the method claims: above the band it is too sure of itself, below "
    "it is too modest.";
constexpr const char* kGeometryNote =
    "Median position error in metres, bars up to the 95 % quantile; below it the share of such frames that the method "
    "answered at all. Counted from convergence on.";

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
    facts += fact("its heading RMSE", numberText(best->heading_error_deg.rmse, 2) + " deg");
  if (score.converged_at_s) facts += fact("until converged", numberText(score.converged_at_s, 1) + " s");
  facts += fact("length of the log", numberText(context.duration_s, 0) + " s");
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
  return section(
      "Methods side by side", methodTable(score) + conclusions,
      from + kIntervalNote + "All methods are judged at the same stamps. A dash: the figure does not exist.");
}

std::string commonSections(const RunContext& context, const RunScore& score)
{
  return section("Landmarks", residualChart(score) + landmarkTable(score),
                 "Residuals of the inliers in units of their standard deviation.") +
         section("Filter", filterTable(score)) + section("Observations", observationTable(context)) +
         section("How to repeat this run", provenanceTable(context, score));
}

/// A drawing, and the place where scripts put a chart instead of it.
std::string chartSection(const std::string& title, const std::string& name, const std::string& drawing,
                         const std::string& note = "")
{
  if (drawing.empty()) return {};
  return section(title, "<div data-chart=\"" + name + "\">" + element("div", "static", "\n" + drawing) + "</div>\n",
                 note);
}

std::string mapSection(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const std::string drawing = element("div", "static", "\n" + svgMap(context, record, score)) + "\n";
  return section("Map", "<div id=\"map\">\n" + drawing + std::string(playbackMarkup()) + "</div>\n");
}

/// Data first: the scripts read it as soon as they run.
std::string scripts(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  return "<script type=\"application/json\" id=\"run-data\">" + pageData(context, record, score) + "</script>\n" +
         element("script", "", chartLibrary()) + "\n<script>\n\"use strict\";\n{" + std::string(pageScript()) +
         "}\n</script>\n";
}

std::string nameOf(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.empty() ? "run" : name;
}

std::string page(const RunContext& context, const RunScore& score, const std::string& subtitle,
                 const std::string& sections, const std::string& scripts = "")
{
  const std::string title = "Landmark localization: " + escapeHtml(nameOf(context.config_path));
  const std::string head =
      "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      std::string(kOffline) + "\"/>\n" + element("title", "", title) + "\n" +
      element("style", "", "\n" + std::string(pageStyle()));
  const std::string header =
      element("header", "", element("h1", "", title) + element("p", "note", escapeHtml(subtitle))) + "\n";
  const std::string body = header + verdictStrip(score) + keyFacts(context, score) + sections;
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" + element("head", "", "\n" + head + "\n") + "\n" +
         element("body", "", "\n" + element("main", "", "\n" + body) + "\n" + scripts) + "\n</html>\n";
}
}  // namespace

std::string trialPage(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const std::string subtitle =
      nameOf(context.rawlog_path) + ", trial " + std::to_string(record.trial) + ", seed " + std::to_string(record.seed);
  const std::string sections =
      methodSection(score) + mapSection(context, record, score) +
      chartSection("Position error over time", "position", positionErrorChart(context, score),
                   "The dashed line is the limit that counts as converged.") +
      chartSection("Heading error over time", "heading", headingErrorChart(context, score)) +
      chartSection("Modes and effective sample size", "confidence", confidenceChart(context, record, score)) +
      chartSection("Honesty of the covariance", "nees", neesChart(context, score), kNeesNote) +
      section("Error against geometry", errorsByGeometrySection(errorsByGeometry(context, record, score), score),
              kGeometryNote) +
      commonSections(context, score);
  return page(context, score, subtitle, sections, scripts(context, record, score));
}

std::string mergedPage(const RunContext& context, const RunScore& merged)
{
  const std::string subtitle = nameOf(context.rawlog_path) + ", " + std::to_string(merged.trials.size()) + " trials";
  return page(context, merged, subtitle,
              section("Trials", trialTable(merged)) + methodSection(merged) + commonSections(context, merged));
}
}  // namespace mrpt_ext
