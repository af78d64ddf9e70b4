#include "mrpt_ext/report/summary_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/report/calibration_text.h"
#include "mrpt_ext/report/json_number.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;

Json number(const OptionalNumber& value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

/// A count is written without a decimal point, unless it is a median between two counts.
Json count(const OptionalNumber& value)
{
  if (value && *value == std::floor(*value) && std::abs(*value) < 1e15) return Json(std::llround(*value));
  return number(value);
}

Json statistics(const ErrorStatistics& s)
{
  return {{"rmse", number(s.rmse)}, {"mean", number(s.mean)}, {"median", number(s.median)}, {"std", number(s.std)},
          {"min", number(s.min)},   {"max", number(s.max)},   {"p95", number(s.p95)}};
}

Json trialsDetail(const std::vector<TrialScore>& trials)
{
  Json list = Json::array();
  for (const TrialScore& trial : trials)
    list.push_back({{"trial", trial.trial},
                    {"seed", trial.seed},
                    {"success", trial.success ? Json(*trial.success) : Json(nullptr)},
                    {"verdict", toString(trial.verdict)},
                    {"rmse", number(trial.rmse)},
                    {"converged_at_s", number(trial.converged_at_s)}});
  return list;
}

Json rawlog(const RunContext& context)
{
  return {{"path", context.rawlog_path},
          {"sha256", context.rawlog_sha256.empty() ? Json(nullptr) : Json(context.rawlog_sha256)},
          {"entries", context.rawlog_entries},
          {"duration_s", number(context.duration_s)}};
}

Json observations(const RunContext& context)
{
  Json all = Json::object();
  for (const auto& [name, entry] : context.observations)
    all[name] = {{"total", entry.total}, {"used", entry.used}, {"ignored", entry.ignored}};
  return all;
}

Json stepTimes(const MethodScore& method)
{
  return {{"median", number(method.step_ms_median)},
          {"p95", number(method.step_ms_p95)},
          {"p99", number(method.step_ms_p99)},
          {"max", number(method.step_ms_max)}};
}

Json methods(const std::vector<MethodScore>& scores)
{
  Json all = Json::object();
  for (const MethodScore& method : scores)
    all[method.name] = {{"estimates", count(method.estimates)},
                        {"availability", number(method.availability)},
                        {"position_error_m", statistics(method.position_error_m)},
                        {"heading_error_deg", statistics(method.heading_error_deg)},
                        {"position_error_whole_run_m", statistics(method.position_error_whole_run_m)},
                        {"position_error_m_with_detections", statistics(method.position_error_with_detections_m)},
                        {"position_error_m_blind", statistics(method.position_error_blind_m)},
                        {"time_per_step_ms", stepTimes(method)}};
  return all;
}

Json modes(const std::optional<std::vector<ModeSummary>>& modes_at_end)
{
  if (!modes_at_end) return nullptr;
  Json list = Json::array();
  for (const ModeSummary& mode : *modes_at_end)
    list.push_back({{"x", number(mode.pose.mean.x)},
                    {"y", number(mode.pose.mean.y)},
                    {"phi_deg", number(radToDeg(mode.pose.mean.phi))},
                    {"weight", number(mode.weight)}});
  return list;
}

Json biases(const std::map<std::string, BiasScore>& scores)
{
  Json all = Json::object();
  for (const auto& [name, bias] : scores) all[name] = {{"mean", number(bias.mean)}, {"std", number(bias.std)}};
  return all;
}

Json filter(const RunScore& score)
{
  const FilterScore& f = score.filter;
  Json json = {
      {"particles",
       {{"min", count(f.particles_min)}, {"median", count(f.particles_median)}, {"max", count(f.particles_max)}}},
      {"nees",
       {{"mean", number(f.nees_mean)}, {"band_low", number(f.nees_band_low)}, {"band_high", number(f.nees_band_high)}}},
      {"coverage_95", number(f.coverage_95)},
      {"effective_sample_ratio_min", number(f.effective_sample_ratio_min)},
      {"converged_at_s", number(score.converged_at_s)},
      {"lost_steps", count(f.lost_steps)},
      {"reseeds", count(f.reseeds)},
      {"late_estimates", count(f.late_estimates)},
      {"most_steps_late", count(f.most_steps_late)},
      {"modes_at_end", modes(f.modes_at_end)}};
  if (!f.biases.empty()) json["biases"] = biases(f.biases);  // only where the configuration asks for some
  return json;
}

Json landmarks(const std::map<std::string, LandmarkScore>& scores)
{
  Json all = Json::object();
  for (const auto& [id, landmark] : scores)
    all[id] = {{"seen", count(landmark.seen)},
               {"associated", number(landmark.associated)},
               {"inlier_rate", number(landmark.inlier_rate)},
               {"residual_mean", number(landmark.residual_mean)},
               {"residual_std", number(landmark.residual_std)}};
  return all;
}

Json shares(const VerdictShares& s)
{
  return {{"ok", number(s.ok)}, {"ambiguous", number(s.ambiguous)}, {"lost", number(s.lost)}};
}

/// Times in seconds since the start of the log.
Json spells(const std::optional<std::vector<VerdictSpell>>& spells_of_run)
{
  if (!spells_of_run) return nullptr;
  Json list = Json::array();
  for (const VerdictSpell& spell : *spells_of_run)
    list.push_back({{"from_s", rounded(spell.from, 3)},
                    {"to_s", rounded(spell.to, 3)},
                    {"verdict", toString(spell.verdict)},
                    {"reason", spell.reason}});
  return list;
}

Json calibrationRow(const CalibrationRow& row)
{
  return {{"log_density", number(row.log_density)},
          {"verdict", toString(row.verdict)},
          {"verdict_shares", shares(row.shares)},
          {"position_rmse_m", number(row.position_rmse_m)}};
}

Json calibration(const RunContext& context, const RunScore& score)
{
  if (!context.calibration) return nullptr;
  Json adopted = Json::array();
  for (const CalibratedValue& value : context.calibration->values)
  {
    const std::optional<double> single = parseNumber(value.value);
    adopted.push_back({{"key", value.section + "." + value.key},
                       {"value", single ? number(single) : Json(value.value)},
                       {"std", number(value.std)}});
  }
  return {{"adopted", adopted},
          {"rows",
           {{"before", calibrationRow(context.calibration->before)},
            {"after", calibrationRow(calibratedRow(context, score))}}}};
}
}  // namespace

Json inputDigests(const RunContext& context)
{
  const auto digest = [](const std::string& sha256) { return sha256.empty() ? Json(nullptr) : Json(sha256); };
  const auto of_file = [&](const std::string& role)
  {
    for (const InputFile& file : context.inputs)
      if (file.role == role) return digest(file.sha256);
    return Json(nullptr);
  };
  return {{"log", digest(context.rawlog_sha256)},
          {"map", of_file("map")},
          {"truth", of_file("truth")},
          {"config", digest(context.settings_sha256)}};
}

std::string summaryJson(const RunContext& context, const RunScore& score)
{
  const MethodScore* found = judgedScore(score);
  const MethodScore judged = found ? *found : MethodScore{};
  const Json summary = {{"schema", 1},
                        {"version", context.version},
                        {"config", context.config_path},
                        {"seed", context.seed},
                        {"trials", score.trials.size()},
                        {"success_rate", number(score.success_rate)},
                        {"trials_detail", trialsDetail(score.trials)},
                        {"rawlog", rawlog(context)},
                        {"inputs", inputDigests(context)},
                        {"observations", observations(context)},
                        {"methods", methods(score.methods)},
                        {"judged_method", score.judged_method ? Json(*score.judged_method) : Json(nullptr)},
                        {"position_error_m_with_detections", statistics(judged.position_error_with_detections_m)},
                        {"time_per_step_ms", stepTimes(judged)},
                        {"filter", filter(score)},
                        {"landmarks", landmarks(score.landmarks)},
                        {"limit",
                         {{"pcrlb_position_rmse_m", number(score.limit.position_rmse_m)},
                          {"pcrlb_heading_rmse_deg", number(score.limit.heading_rmse_deg)}}},
                        {"verdict", toString(score.verdict)},
                        {"verdict_reason", score.verdict_reason},
                        {"hints", score.hints},
                        {"calibration", calibration(context, score)},
                        {"verdict_shares", shares(score.verdict_shares)},
                        {"verdict_spells", spells(score.verdict_spells)},
                        {"cost",
                         {{"cpu_s", number(score.cost.cpu_s)},
                          {"wall_s", number(score.cost.wall_s)},
                          {"peak_memory_mb", number(score.cost.peak_memory_mb)},
                          {"realtime_factor", number(score.cost.realtime_factor)}}}};
  // A path or a label may hold bytes that are not UTF-8: they are replaced, the summary is still written.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
}  // namespace mrpt_ext
