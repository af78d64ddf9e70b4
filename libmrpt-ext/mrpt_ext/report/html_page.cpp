#include "mrpt_ext/report/html_page.h"

#include <algorithm>
#include <set>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/calibration_text.h"
#include "mrpt_ext/report/comparison_text.h"
#include "mrpt_ext/report/html_advice.h"
#include "mrpt_ext/report/html_geometry.h"
#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/page_assets.h"
#include "mrpt_ext/report/page_data.h"
#include "mrpt_ext/report/svg_map.h"
#include "mrpt_ext/report/verdict_text.h"

namespace mrpt_ext
{
namespace
{
constexpr const char* kMethodNote =
    "All methods are judged at the same stamps. The 95 % interval is a bootstrap: over blocks of ten neighbouring "
    "stamps "
    "within a trial, over trials in a merged report. A dash marks a number that does not exist.";
constexpr const char* kLimitNote = "Dashed line: the limit below which the filter counts as converged.";
constexpr const char* kReseedingNote =
    "The filter looks for the robot elsewhere when the detections do not agree with its modes. The reason is its "
    "judgement one frame before.";
constexpr const char* kNeesNote =
    "Normalised estimation error squared: the error in units of the reported covariance. Above the band the filter is "
    "overconfident, below it is underconfident.";
constexpr const char* kBiasNote = "Estimate of each bias with one standard deviation to either side.";
constexpr const char* kGeometryNote =
    "Chart: median position error of each method, with a bar up to the 95 % quantile. Table: median position error in "
    "metres and, below it, the share of frames in which the method gave an estimate. Errors count from convergence on.";
constexpr const char* kResidualNote =
    "Residuals of the inliers in units of their standard deviation: mean, with one standard deviation to either side. "
    "Unbiased landmarks lie within the band.";

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
  if (const MethodScore* judged = judgedScore(score))
  {
    const OptionalNumber &seeing = judged->position_error_with_detections_m.rmse,
                         &blind = judged->position_error_blind_m.rmse;
    if (seeing) facts += fact("position RMSE with detections: " + judged->name, magnitudeText(seeing) + " m");
    if (blind) facts += fact("position RMSE, blind for more than 2 s", magnitudeText(blind) + " m");
  }
  if (score.verdict_shares.ok) facts += fact("of the frames are ok", percentText(score.verdict_shares.ok));
  if (best && best->name != score.judged_method)
    facts += fact("lowest position RMSE: " + best->name, magnitudeText(best->position_error_m.rmse) + " m");
  if (best && best->heading_error_deg.rmse)
    facts += fact("heading RMSE of " + best->name, numberText(best->heading_error_deg.rmse, 2) + " deg");
  if (score.converged_at_s) facts += fact("time to convergence", numberText(score.converged_at_s, 1) + " s");
  facts += fact("duration of the log", numberText(context.duration_s, 0) + " s");
  if (score.cost.realtime_factor) facts += fact("times real time", magnitudeText(score.cost.realtime_factor));
  return element("div", "facts-strip", facts) + "\n";
}

std::string verdictStrip(const RunScore& score)
{
  const std::string verdict = toString(score.verdict);
  std::string html = element("p", "word", element("span", "symbol", verdictSymbol(score.verdict)) + verdict);
  html += element("p", "reason", escapeHtml(score.verdict_reason));
  html += element("p", "", escapeHtml(outcomeText(score)));
  for (const std::string& hint : score.hints) html += element("p", "hint", "Hint: " + escapeHtml(hint));
  if (needsAdvice(score)) html += element("p", "", "<a href=\"#what-to-do\">What to do</a>");
  if (score.interrupted) html += element("p", "", "Interrupted: the scores cover only the finished part.");
  return element("section", "verdict " + verdict, "\n" + html) + "\n";
}

std::string verdictSection(const RunScore& score)
{
  const std::string shares = sharesText(score.verdict_shares);
  if (shares.empty()) return {};
  return htmlSection("Verdict over the run", element("p", "", escapeHtml(shares)) + "\n" + spellTable(score),
                     "A share counts frames. The verdict comes from the filter alone, never from the truth.");
}

/// Of what this run needs; empty when it needs none.
std::string adviceSection(const RunScore& score)
{
  if (!needsAdvice(score) && score.filter.reseeds.value_or(0) == 0) return {};
  return htmlSection("<a id=\"what-to-do\">What to do</a>", adviceList(score),
                     escapeHtml(std::string("More: ") + kAdviceSection));
}

std::string methodSection(const RunScore& score)
{
  const std::string from = score.judged_method
                               ? "Errors count from the convergence of " + escapeHtml(*score.judged_method) +
                                     " on; “whole run” counts all estimates. "
                               : "All estimates count. ";
  std::string conclusions;
  if (const std::string limit = limitText(score); !limit.empty()) conclusions += element("li", "", escapeHtml(limit));
  for (const std::string& sentence : comparisonSentences(score)) conclusions += element("li", "", escapeHtml(sentence));
  if (!conclusions.empty()) conclusions = element("ul", "", conclusions) + "\n";
  return htmlSection("Comparison of methods", methodTable(score) + conclusions, from + kMethodNote);
}

/// Empty when no landmark has a residual.
std::string residualBox(const RunScore& score)
{
  const bool any = std::any_of(score.landmarks.begin(), score.landmarks.end(),
                               [](const auto& landmark) { return landmark.second.residual_mean.has_value(); });
  return any ? chartBox("residuals") : std::string();
}

std::string commonSections(const RunContext& context, const RunScore& score)
{
  return htmlSection("Landmarks", residualBox(score) + landmarkTable(score), kResidualNote) +
         htmlSection("Filter", filterTable(score)) + htmlSection("Observations", observationTable(context)) +
         htmlSection("Reproducing this run", provenanceTable(context, score));
}

bool anyError(const RunScore& score)
{
  return std::any_of(score.methods.begin(), score.methods.end(),
                     [](const MethodScore& method) { return !method.errors.empty(); });
}

bool anyHeadingError(const RunScore& score)
{
  const auto known = [](const ErrorSample& error) { return error.heading_deg.has_value(); };
  return std::any_of(score.methods.begin(), score.methods.end(),
                     [&](const MethodScore& method)
                     { return std::any_of(method.errors.begin(), method.errors.end(), known); });
}

std::string biasCharts(const RunRecord& record)
{
  std::set<std::string> names;
  for (const BiasRow& row : record.biases) names.insert(row.name);
  std::string html;
  std::size_t index = 0;
  for (const std::string& name : names) html += element("h3", "", escapeHtml(name)) + "\n" + chartBox("bias", index++);
  return html;
}

std::string chartSections(const RunRecord& record, const RunScore& score)
{
  const auto box = [](bool exists, const char* name) { return exists ? chartBox(name) : std::string(); };
  const MethodTrajectory* judged = judgedMethod(record);
  return htmlSection("Position error over time", box(anyError(score), "position"), kLimitNote) +
         htmlSection("Heading error over time", box(anyHeadingError(score), "heading")) +
         htmlSection("Modes and effective sample size", box(judged && !judged->points.empty(), "confidence")) +
         htmlSection("Covariance consistency (NEES)", box(judged && !score.filter.nees.empty(), "nees"), kNeesNote) +
         htmlSection("Estimated biases", biasCharts(record), kBiasNote);
}

std::string mapSection(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const std::string drawing = element("div", "static", "\n" + svgMap(context, record, score)) + "\n";
  return htmlSection("Map", "<div id=\"map\">\n" + drawing + std::string(playbackMarkup()) + "</div>\n");
}

/// Data first: the scripts read it as soon as they run.
std::string scripts(const std::string& data)
{
  return "<script type=\"application/json\" id=\"run-data\">" + data + "</script>\n" +
         element("script", "", chartLibrary()) + "\n<script>\n\"use strict\";\n{" + std::string(pageScript()) +
         "}\n</script>\n";
}

std::string nameOf(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.empty() ? "run" : name;
}

std::string page(const RunContext& context, const RunScore& score, const std::string& subtitle,
                 const std::string& sections, const std::string& scripts)
{
  return htmlPage("Landmark localization: " + nameOf(context.config_path), subtitle,
                  verdictStrip(score) + keyFacts(context, score) + calibrationSection(context, score) +
                      verdictSection(score) + sections + adviceSection(score),
                  scripts);
}
}  // namespace

std::string trialPage(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const std::string subtitle =
      nameOf(context.rawlog_path) + ", trial " + std::to_string(record.trial) + ", seed " + std::to_string(record.seed);
  const std::vector<ErrorsByGeometry> geometry = errorsByGeometry(context, record, score);
  const std::string sections =
      methodSection(score) + htmlSection("Injected hypotheses", reseedingTable(record, context), kReseedingNote) +
      mapSection(context, record, score) + chartSections(record, score) +
      htmlSection("Position error by geometry", errorsByGeometrySection(geometry, score), kGeometryNote) +
      commonSections(context, score);
  return page(context, score, subtitle, sections, scripts(pageData(context, record, score, geometry)));
}

std::string mergedPage(const RunContext& context, const RunScore& merged)
{
  const std::string subtitle = nameOf(context.rawlog_path) + ", " + std::to_string(merged.trials.size()) + " trials";
  const std::string sections =
      htmlSection("Trials", trialTable(merged)) + methodSection(merged) + commonSections(context, merged);
  const bool charts = !residualBox(merged).empty();
  return page(context, merged, subtitle, sections, charts ? scripts(mergedPageData(merged)) : std::string());
}
}  // namespace mrpt_ext
