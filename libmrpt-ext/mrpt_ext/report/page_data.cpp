#include "mrpt_ext/report/page_data.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/error_series.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/json_number.h"
#include "mrpt_ext/report/landmark_quality.h"
#include "mrpt_ext/report/map_view.h"
#include "mrpt_ext/report/playback_json.h"
#include "mrpt_ext/report/verdict_spans.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr std::size_t kMaxStamps = 2400;

Json figure(const OptionalNumber& value, int decimals) { return value ? rounded(*value, decimals) : Json(nullptr); }

Json columns(const std::vector<std::vector<OptionalNumber>>& methods, int decimals)
{
  Json all = Json::array();
  for (const auto& method : methods)
  {
    Json column = Json::array();
    for (const OptionalNumber& value : method) column.push_back(figure(value, decimals));
    all.push_back(std::move(column));
  }
  return all;
}

Json methodsOf(const RunScore& score)
{
  const std::vector<std::string> names = methodNames(score.methods);
  Json list = Json::array();
  for (const MethodScore& method : score.methods)
    list.push_back({{"name", method.name},
                    {"colour", methodClass(method.name, names)},
                    {"continuous", method.continuous},
                    {"oracle", method.oracle},
                    {"placed", method.name != kOdometryMethod || !method.errors.empty()}});
  return list;
}

Json errorsOf(const RunContext& context, const RunScore& score)
{
  const ErrorSeries series = errorSeries(context, score, kMaxStamps);
  Json stamps = Json::array();
  for (const double stamp : series.stamps) stamps.push_back(rounded(stamp, 3));
  return {{"t", stamps},
          {"joined", series.seconds_joined},
          {"position", columns(series.position_m, 4)},
          {"heading", columns(series.heading_deg, 3)}};
}

Json landmarksOf(const RunContext& context, const RunScore& score)
{
  Json list = Json::array();
  for (const Landmark& landmark : context.map.all())
  {
    const std::string id = landmark.id == kNoId ? std::string() : std::to_string(landmark.id);
    const auto known = score.landmarks.find(id);
    const std::string doubt = known == score.landmarks.end() ? std::string() : landmarkWarning(known->second);
    list.push_back(
        {rounded(landmark.position.x(), 3), rounded(landmark.position.y(), 3), id, landmark.category, doubt});
  }
  return list;
}

Json spansOf(const MethodTrajectory& trajectory, Verdict verdict, const RunContext& context)
{
  Json list = Json::array();
  for (const VerdictSpan& span : verdictSpans(trajectory, verdict, context.start_time, context.duration_s / 700))
    list.push_back({rounded(span.from, 2), rounded(span.to, 2)});
  return list;
}

/// Neighbours are joined by the least of them.
Json confidenceOf(const RunContext& context, const RunRecord& record)
{
  Json t = Json::array(), weight = Json::array(), ess = Json::array(), modes = Json::array();
  const MethodTrajectory* trajectory = judgedMethod(record);
  if (!trajectory) return nullptr;
  const std::size_t joined = trajectory->points.size() / (kMaxStamps + 1) + 1;
  for (auto point = trajectory->points.begin(); point != trajectory->points.end();)
  {
    double least_weight = 1;
    OptionalNumber least_ess;
    int most_modes = 0;
    t.push_back(rounded(point->time - context.start_time, 3));
    for (std::size_t k = 0; k < joined && point != trajectory->points.end(); ++k, ++point)
    {
      least_weight = std::min(least_weight, point->best_weight);
      if (const auto& e = point->effective_samples) least_ess = std::min(least_ess.value_or(1), *e);
      most_modes = std::max(most_modes, point->modes);
    }
    weight.push_back(rounded(least_weight, 3));
    ess.push_back(figure(least_ess, 4));
    modes.push_back(most_modes);
  }
  Json reseeds = Json::array();
  for (const double time : record.filter.reseed_times) reseeds.push_back(rounded(time - context.start_time, 2));
  return {{"t", t},
          {"weight", weight},
          {"ess", ess},
          {"modes", modes},
          {"reseeds", reseeds},
          {"ambiguous", spansOf(*trajectory, Verdict::ambiguous, context)},
          {"lost", spansOf(*trajectory, Verdict::lost, context)}};
}

/// Upper triangle, row by row.
Json covarianceOf(const Matrix3d& P)
{
  Json list = Json::array();
  for (int r = 0; r < 3; ++r)
    for (int c = r; c < 3; ++c) list.push_back(rounded(P(r, c), 10));
  return list;
}

Json neesOf(const RunContext& context, const RunScore& score)
{
  if (score.filter.nees.empty()) return nullptr;
  Json t = Json::array(), value = Json::array(), covariance = Json::array();
  const std::size_t joined = score.filter.nees.size() / (kMaxStamps + 1) + 1;
  const auto& samples = score.filter.nees;
  for (std::size_t i = 0; i < samples.size(); i += joined)
  {
    const auto end = samples.begin() + static_cast<std::ptrdiff_t>(std::min(i + joined, samples.size()));
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
          {"mean", figure(score.filter.nees_mean, 3)}};
}
}  // namespace

std::string pageData(const RunContext& context, const RunRecord& record, const RunScore& score)
{
  const auto [low, high] = mapExtent(context, judgedMethod(record));
  const Json json = {{"duration", rounded(context.duration_s, 3)},
                     {"extent", {rounded(low.x(), 3), rounded(low.y(), 3), rounded(high.x(), 3), rounded(high.y(), 3)}},
                     {"judged", score.judged_method ? Json(*score.judged_method) : Json(nullptr)},
                     {"converged", figure(score.converged_at_s, 2)},
                     {"limit_m", score.judged_method ? rounded(score.limits.within_m, 3) : Json(nullptr)},
                     {"limit_deg", score.judged_method ? rounded(score.limits.within_deg, 3) : Json(nullptr)},
                     {"methods", methodsOf(score)},
                     {"errors", errorsOf(context, score)},
                     {"confidence", confidenceOf(context, record)},
                     {"nees", neesOf(context, score)},
                     {"landmarks", landmarksOf(context, score)},
                     {"playback", playbackJson(context, record)}};
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
    safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return safe;
}
}  // namespace mrpt_ext
