#include "mrpt_ext/report/chart_data.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/error_series.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/json_number.h"
#include "mrpt_ext/report/landmark_quality.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr std::size_t kMaxStamps = 2400;  // more than a chart can resolve

Json number(const OptionalNumber& value, int decimals) { return value ? rounded(*value, decimals) : Json(nullptr); }

Json columns(const std::vector<std::vector<OptionalNumber>>& methods, int decimals)
{
  Json all = Json::array();
  for (const auto& method : methods)
  {
    Json column = Json::array();
    for (const OptionalNumber& value : method) column.push_back(number(value, decimals));
    all.push_back(std::move(column));
  }
  return all;
}

/// [[from, to], ...] in which the trajectory has this verdict; spans closer than a chart can resolve are merged,
/// shorter ones widened.
Json spansOf(const MethodTrajectory& trajectory, Verdict verdict, const RunContext& context)
{
  const double resolution = context.duration_s / 700;
  std::vector<std::pair<double, double>> spans;
  bool within = false;  // the last of `spans` still holds
  for (const PoseEstimate& point : trajectory.points)
  {
    const double time = point.time - context.start_time;
    const bool matches = point.verdict == verdict;
    if (matches && !within && (spans.empty() || time - spans.back().second >= resolution))
      spans.emplace_back(time, time + resolution);
    if (matches || within) spans.back().second = std::max(spans.back().second, time);
    within = matches;
  }
  Json list = Json::array();
  for (const auto& [from, to] : spans) list.push_back({rounded(from, 2), rounded(to, 2)});
  return list;
}

/// Upper triangle, row by row.
Json covarianceOf(const Matrix3d& P)
{
  Json list = Json::array();
  for (int r = 0; r < 3; ++r)
    for (int c = r; c < 3; ++c) list.push_back(rounded(P(r, c), 10));
  return list;
}

OptionalNumber medianOf(const GeometryCell& cell) { return cell.median; }
OptionalNumber p95Of(const GeometryCell& cell) { return cell.p95; }

/// One column per method, null for oracles.
Json columnsOf(const ErrorsByGeometry& table, const RunScore& score, OptionalNumber (*number_of)(const GeometryCell&))
{
  Json all = Json::array();
  for (std::size_t m = 0; m < score.methods.size(); ++m)
  {
    Json column = Json::array();
    for (const GeometryClass& c : table.classes) column.push_back(number(number_of(c.methods[m]), 4));
    all.push_back(score.methods[m].oracle ? Json(nullptr) : std::move(column));
  }
  return all;
}
}  // namespace

Json errorData(const RunContext& context, const RunScore& score)
{
  const ErrorSeries series = errorSeries(context, score, kMaxStamps);
  Json stamps = Json::array();
  for (const double stamp : series.stamps) stamps.push_back(rounded(stamp, 3));
  return {{"t", stamps},
          {"stamps_per_entry", series.stamps_per_entry},
          {"position", columns(series.position_m, 4)},
          {"heading", columns(series.heading_deg, 3)}};
}

Json confidenceData(const RunContext& context, const RunRecord& record)
{
  const MethodTrajectory* trajectory = judgedMethod(record);
  if (!trajectory || trajectory->points.empty()) return nullptr;
  Json t = Json::array(), weight = Json::array(), ess = Json::array();
  const std::size_t merged = entriesPerPoint(trajectory->points.size(), kMaxStamps);
  for (auto point = trajectory->points.begin(); point != trajectory->points.end();)
  {
    double least_weight = 1;
    OptionalNumber least_ess;
    t.push_back(rounded(point->time - context.start_time, 3));
    for (std::size_t k = 0; k < merged && point != trajectory->points.end(); ++k, ++point)
    {
      least_weight = std::min(least_weight, point->best_weight);
      if (const auto& e = point->effective_samples) least_ess = std::min(least_ess.value_or(1), *e);
    }
    weight.push_back(rounded(least_weight, 3));
    ess.push_back(number(least_ess, 4));
  }
  Json reseeds = Json::array();
  for (const Reseeding& reseeding : record.filter.reseedings)
    reseeds.push_back(rounded(reseeding.time - context.start_time, 2));
  return {{"t", t},
          {"weight", weight},
          {"ess", ess},
          {"reseeds", reseeds},
          {"ambiguous", spansOf(*trajectory, Verdict::ambiguous, context)},
          {"lost", spansOf(*trajectory, Verdict::lost, context)}};
}

Json neesData(const RunContext& context, const RunScore& score)
{
  if (score.filter.nees.empty() || !score.judged_method) return nullptr;
  Json t = Json::array(), value = Json::array(), covariance = Json::array();
  const std::size_t merged = entriesPerPoint(score.filter.nees.size(), kMaxStamps);
  const auto& samples = score.filter.nees;
  for (std::size_t i = 0; i < samples.size(); i += merged)
  {
    const auto end = samples.begin() + static_cast<std::ptrdiff_t>(std::min(i + merged, samples.size()));
    const auto worst = std::max_element(samples.begin() + static_cast<std::ptrdiff_t>(i), end,
                                        [](const NeesSample& a, const NeesSample& b) { return a.value < b.value; });
    t.push_back(rounded(samples[i].stamp - context.start_time, 3));
    value.push_back(rounded(worst->value, 3));
    covariance.push_back(covarianceOf(worst->covariance));
  }
  const int freedom = samples.front().degrees_of_freedom;
  return {{"t", t},
          {"value", value},
          {"covariance", covariance},
          {"low", rounded(chiSquareQuantile(freedom, 0.025), 4)},
          {"high", rounded(chiSquareQuantile(freedom, 0.975), 4)},
          {"mean", number(score.filter.nees_mean, 3)}};
}

Json biasData(const RunContext& context, const RunRecord& record)
{
  std::map<std::string, std::size_t> count, next;  // rows of each bias, and those read so far
  for (const BiasRow& row : record.biases) ++count[row.name];
  std::map<std::string, Json> curves;
  for (const auto& [name, rows] : count)
    curves[name] = {{"name", name}, {"t", Json::array()}, {"mean", Json::array()}, {"std", Json::array()}};
  for (const BiasRow& row : record.biases)
  {
    if (next[row.name]++ % entriesPerPoint(count[row.name], kMaxStamps) != 0) continue;
    Json& curve = curves[row.name];
    curve["t"].push_back(rounded(row.time - context.start_time, 3));
    curve["mean"].push_back(rounded(row.mean, 6));
    curve["std"].push_back(rounded(row.std, 6));
  }
  Json list = Json::array();
  for (auto& [name, curve] : curves) list.push_back(std::move(curve));
  return list;
}

Json geometryData(const std::vector<ErrorsByGeometry>& tables, const RunScore& score)
{
  Json list = Json::array();
  for (const ErrorsByGeometry& table : tables)
  {
    Json classes = Json::array();
    for (const GeometryClass& c : table.classes) classes.push_back(c.label);
    list.push_back({{"quantity", table.quantity},
                    {"classes", classes},
                    {"median", columnsOf(table, score, medianOf)},
                    {"p95", columnsOf(table, score, p95Of)}});
  }
  return list;
}

Json residualData(const RunScore& score)
{
  Json ids = Json::array(), mean = Json::array(), std = Json::array(), warning = Json::array();
  for (const std::string& id : landmarkOrder(score))
  {
    const LandmarkScore& landmark = score.landmarks.at(id);
    if (!landmark.residual_mean) continue;
    ids.push_back(id);
    mean.push_back(rounded(*landmark.residual_mean, 3));
    std.push_back(rounded(landmark.residual_std.value_or(0), 3));
    warning.push_back(landmarkWarning(landmark));
  }
  if (ids.empty()) return nullptr;
  return {{"ids", ids}, {"mean", mean}, {"std", std}, {"warning", warning}};
}
}  // namespace mrpt_ext
