#include "mrpt_ext/report/summary_reader.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "mrpt_ext/report/summary_json.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::ordered_json;

OptionalNumber numberOf(const Json& value)
{
  return value.is_number() ? OptionalNumber(value.get<double>()) : std::nullopt;
}

/// Of a member that older versions did not write.
OptionalNumber laterNumberOf(const Json& value, const char* key)
{
  return value.contains(key) ? numberOf(value.at(key)) : std::nullopt;
}

ErrorStatistics statisticsOf(const Json& value)
{
  ErrorStatistics s;
  s.rmse = numberOf(value.at("rmse"));
  s.mean = numberOf(value.at("mean"));
  s.median = numberOf(value.at("median"));
  s.std = numberOf(value.at("std"));
  s.min = numberOf(value.at("min"));
  s.max = numberOf(value.at("max"));
  s.p95 = numberOf(value.at("p95"));
  return s;
}

MethodScore methodOf(const std::string& name, const Json& value)
{
  MethodScore method;
  method.name = name;
  method.oracle = name.starts_with("oracle_");
  method.estimates = numberOf(value.at("estimates"));
  method.availability = numberOf(value.at("availability"));
  method.position_error_m = statisticsOf(value.at("position_error_m"));
  method.heading_error_deg = statisticsOf(value.at("heading_error_deg"));
  method.position_error_whole_run_m = statisticsOf(value.at("position_error_whole_run_m"));
  method.position_error_with_detections_m = statisticsOf(value.at("position_error_m_with_detections"));
  method.position_error_blind_m = statisticsOf(value.at("position_error_m_blind"));
  const Json& step = value.at("time_per_step_ms");
  method.step_ms_median = numberOf(step.at("median"));
  method.step_ms_p95 = numberOf(step.at("p95"));
  method.step_ms_p99 = numberOf(step.at("p99"));
  method.step_ms_max = numberOf(step.at("max"));
  return method;
}

FilterScore filterOf(const Json& value)
{
  FilterScore filter;
  filter.particles_min = numberOf(value.at("particles").at("min"));
  filter.particles_median = numberOf(value.at("particles").at("median"));
  filter.particles_max = numberOf(value.at("particles").at("max"));
  filter.nees_mean = numberOf(value.at("nees").at("mean"));
  filter.nees_band_low = numberOf(value.at("nees").at("band_low"));
  filter.nees_band_high = numberOf(value.at("nees").at("band_high"));
  filter.coverage_95 = numberOf(value.at("coverage_95"));
  filter.effective_sample_ratio_min = numberOf(value.at("effective_sample_ratio_min"));
  filter.lost_steps = numberOf(value.at("lost_steps"));
  filter.reseeds = numberOf(value.at("reseeds"));
  filter.late_estimates = laterNumberOf(value, "late_estimates");
  filter.most_steps_late = laterNumberOf(value, "most_steps_late");
  return filter;
}

LandmarkScore landmarkOf(const Json& value)
{
  return {numberOf(value.at("seen")), numberOf(value.at("associated")), numberOf(value.at("inlier_rate")),
          numberOf(value.at("residual_mean")), numberOf(value.at("residual_std"))};
}

Verdict verdictOf(const std::string& name)
{
  return name == "ok" ? Verdict::ok : name == "ambiguous" ? Verdict::ambiguous : Verdict::lost;
}

VerdictShares sharesOf(const Json& value)
{
  return {numberOf(value.at("ok")), numberOf(value.at("ambiguous")), numberOf(value.at("lost"))};
}

std::vector<VerdictSpell> spellsOf(const Json& list)
{
  std::vector<VerdictSpell> spells;
  for (const Json& spell : list)
    spells.push_back({spell.at("from_s"), spell.at("to_s"), verdictOf(spell.at("verdict")), spell.at("reason")});
  return spells;
}

TrialScore readTrial(const Json& detail)
{
  TrialScore trial;
  trial.trial = detail.at("trial");
  trial.seed = detail.at("seed");
  if (detail.at("success").is_boolean()) trial.success = detail.at("success").get<bool>();
  trial.verdict = verdictOf(detail.at("verdict"));
  trial.rmse = numberOf(detail.at("rmse"));
  trial.converged_at_s = numberOf(detail.at("converged_at_s"));
  return trial;
}

bool belongsTo(const Json& summary, const RunContext& context, int trial)
{
  const std::string reason = summary.at("verdict_reason");
  return !reason.starts_with(kInterruptedReason) && summary.at("schema") == 1 && summary.at("trials") == 1 &&
         summary.at("seed") == context.seed && summary.at("trials_detail").at(0).at("trial") == trial &&
         summary.at("inputs") == inputDigests(context);
}
}  // namespace

RunScore runScoreOf(const nlohmann::ordered_json& summary)
{
  RunScore score;
  for (const auto& [name, method] : summary.at("methods").items()) score.methods.push_back(methodOf(name, method));
  if (const Json& judged = summary.at("judged_method"); judged.is_string()) score.judged_method = judged;
  score.filter = filterOf(summary.at("filter"));
  for (const auto& [id, landmark] : summary.at("landmarks").items()) score.landmarks[id] = landmarkOf(landmark);
  score.limit.position_rmse_m = numberOf(summary.at("limit").at("pcrlb_position_rmse_m"));
  score.limit.heading_rmse_deg = numberOf(summary.at("limit").at("pcrlb_heading_rmse_deg"));
  const Json& cost = summary.at("cost");
  score.cost = {numberOf(cost.at("cpu_s")), numberOf(cost.at("wall_s")), numberOf(cost.at("peak_memory_mb")),
                numberOf(cost.at("realtime_factor"))};
  score.converged_at_s = numberOf(summary.at("filter").at("converged_at_s"));
  score.trials = {readTrial(summary.at("trials_detail").at(0))};
  score.success_rate = numberOf(summary.at("success_rate"));
  score.hints = summary.at("hints").get<std::vector<std::string>>();
  score.verdict_shares = sharesOf(summary.at("verdict_shares"));
  if (const Json& spells = summary.at("verdict_spells"); spells.is_array()) score.verdict_spells = spellsOf(spells);
  score.verdict = verdictOf(summary.at("verdict"));
  score.verdict_reason = summary.at("verdict_reason");
  return score;
}

std::optional<RunScore> readTrialScore(const std::filesystem::path& folder, const RunContext& context, int trial)
{
  std::ifstream file(folder / "summary.json");
  if (!file) return std::nullopt;
  try
  {
    const Json summary = Json::parse(file);
    if (!belongsTo(summary, context, trial)) return std::nullopt;
    return runScoreOf(summary);
  }
  catch (const Json::exception&)
  {
    return std::nullopt;
  }
}
}  // namespace mrpt_ext
