#include "mrpt_ext/report/html_charts.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/svg_chart.h"
#include "mrpt_ext/report/verdict_spans.h"

namespace mrpt_ext
{
namespace
{
constexpr double kLeastNees = 0.02, kMostNees = 1000;  // what lies outside is drawn on the edge

OptionalNumber positionOf(const ErrorSample& error) { return error.position_m; }
OptionalNumber headingOf(const ErrorSample& error) { return error.heading_deg; }

/// Adds one series per method that has the error; closed forms as dots.
std::vector<LegendEntry> addErrors(Chart& chart, const RunContext& context, const RunScore& score,
                                   OptionalNumber (*error_of)(const ErrorSample&))
{
  std::vector<LegendEntry> legend;
  for (const MethodScore& method : score.methods)
  {
    ChartSeries series{methodClass(method.name, methodNames(score.methods)), !method.continuous, {}};
    if (method.oracle) series.css_class += " oracle";
    for (const ErrorSample& error : method.errors)
      if (const OptionalNumber value = error_of(error))
        series.points.emplace_back(error.time - context.start_time, *value);
    if (series.points.empty()) continue;
    const std::string symbol = series.dots ? "dot" : method.name == "odometry" ? "dash" : "line";
    legend.push_back({series.css_class, symbol, method.name});
    chart.series.push_back(std::move(series));
  }
  return legend;
}

std::string errorChart(const RunContext& context, const RunScore& score, OptionalNumber (*error_of)(const ErrorSample&),
                       Chart chart)
{
  chart.duration = context.duration_s;
  chart.break_after = context.truth_is_sparse ? 0 : 2.5;  // scoring stamps are 1 s apart
  const std::vector<LegendEntry> legend = addErrors(chart, context, score, error_of);
  if (chart.series.empty()) return {};
  if (score.converged_at_s)
    chart.marks.push_back({*score.converged_at_s, *score.converged_at_s, "converged",
                           "converged after " + numberText(score.converged_at_s, 1) + " s"});
  return svgChart(chart) + htmlLegend(legend);
}

/// Marks closer than this are drawn as one: the drawing could not show them apart.
double resolutionOf(const Chart& chart) { return chart.duration / 700; }

void addVerdictSpans(Chart& chart, const MethodTrajectory& trajectory, double start, Verdict verdict)
{
  for (const VerdictSpan& span : verdictSpans(trajectory, verdict, start, resolutionOf(chart)))
    chart.marks.push_back({span.from, span.to, std::string("span ") + toString(verdict), toString(verdict)});
}

void addReseeds(Chart& chart, const std::vector<double>& times, double start)
{
  double last = -HUGE_VAL;
  for (const double time : times)
  {
    if (time - last < resolutionOf(chart)) continue;
    chart.marks.push_back({time - start, time - start, "reseed", "re-seeded"});
    last = time;
  }
}
}  // namespace

std::string positionErrorChart(const RunContext& context, const RunScore& score)
{
  Chart chart;
  chart.description = "Position error of all methods over time";
  chart.unit = "m";
  if (score.judged_method) chart.level = score.limits.within_m;
  return errorChart(context, score, positionOf, std::move(chart));
}

std::string headingErrorChart(const RunContext& context, const RunScore& score)
{
  Chart chart;
  chart.description = "Heading error of all methods over time";
  chart.unit = "deg";
  if (score.judged_method) chart.level = score.limits.within_deg;
  return errorChart(context, score, headingOf, std::move(chart));
}

std::string confidenceChart(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const MethodTrajectory* trajectory = judgedMethod(record);
  if (!trajectory || trajectory->points.empty()) return {};
  Chart chart;
  chart.description = "Weight of the reported mode and effective sample ratio over time";
  chart.unit = "share";
  chart.duration = context.duration_s;
  chart.top = 1.0;
  ChartSeries weight{methodClass(trajectory->name, methodNames(score.methods)), false, {}}, samples{"ess", false, {}};
  for (const PoseEstimate& point : trajectory->points)
  {
    weight.points.emplace_back(point.time - context.start_time, point.best_weight);
    if (point.effective_samples) samples.points.emplace_back(point.time - context.start_time, *point.effective_samples);
  }
  std::vector<LegendEntry> legend{{weight.css_class, "line", "weight of the reported mode"}};
  if (!samples.points.empty()) legend.push_back({"ess", "line", "effective sample ratio"});
  chart.series = {std::move(samples), std::move(weight)};
  addVerdictSpans(chart, *trajectory, context.start_time, Verdict::ambiguous);
  if (!chart.marks.empty()) legend.push_back({"ambiguous", "area", "verdict ambiguous"});
  const std::size_t ambiguous_spans = chart.marks.size();
  addVerdictSpans(chart, *trajectory, context.start_time, Verdict::lost);
  if (chart.marks.size() > ambiguous_spans) legend.push_back({"lost", "area", "verdict lost"});
  addReseeds(chart, record.filter.reseed_times, context.start_time);
  const std::size_t reseeds = record.filter.reseed_times.size();
  if (reseeds > 0) legend.push_back({"reseed", "bar", "re-seeded (" + std::to_string(reseeds) + " times)"});
  return svgChart(chart) + htmlLegend(legend);
}

std::string neesChart(const RunContext& context, const RunScore& score)
{
  if (score.filter.nees.empty() || !score.judged_method) return {};
  Chart chart;
  chart.description = "Normalised estimation error squared over time";
  chart.unit = "NEES";
  chart.duration = context.duration_s;
  const int freedom = score.filter.nees.front().degrees_of_freedom;
  chart.band = {chiSquareQuantile(freedom, 0.025), chiSquareQuantile(freedom, 0.975)};
  chart.level = score.filter.nees_mean;
  ChartSeries series{methodClass(*score.judged_method, methodNames(score.methods)), false, {}};
  for (const NeesSample& sample : score.filter.nees)
    series.points.emplace_back(sample.stamp - context.start_time, std::clamp(sample.value, kLeastNees, kMostNees));
  chart.break_after = context.truth_is_sparse ? 0 : 2.5;
  std::vector<LegendEntry> legend{{series.css_class, "line", "NEES of " + *score.judged_method},
                                  {"band", "area", "95 % band of one estimate"}};
  if (chart.level) legend.push_back({"level", "dash", "mean " + numberText(chart.level, 2)});
  chart.series.push_back(std::move(series));
  return svgChart(chart) + htmlLegend(legend);
}
}  // namespace mrpt_ext
