#include "mrpt_ext/report/html_tables.h"

#include <algorithm>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/report/html_parts.h"
#include "mrpt_ext/report/html_text.h"
#include "mrpt_ext/report/landmark_quality.h"
#include "mrpt_ext/report/map_view.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/verdict_text.h"

namespace mrpt_ext
{
namespace
{
std::string intervalText(const OptionalNumber& low, const OptionalNumber& high)
{
  return low && high ? magnitudeText(low) + " – " + magnitudeText(high) : kNoNumber;
}

std::string methodRow(const MethodScore& method, const RunScore& score, bool best)
{
  const std::string name = keyedName(method.name, methodNames(score.methods));
  const std::string badge = best            ? element("span", "badge best", "best")
                            : method.oracle ? element("span", "badge", "uses the truth")
                                            : "";
  const ErrorStatistics& error = method.position_error_m;
  std::string css_class = best ? "best" : method.oracle ? "oracle" : "";
  return htmlRow(
      {name + badge, countText(method.estimates), percentText(method.availability), magnitudeText(error.rmse),
       intervalText(method.rmse_low, method.rmse_high), magnitudeText(error.median), magnitudeText(error.p95),
       magnitudeText(error.max), numberText(method.heading_error_deg.rmse, 2),
       magnitudeText(method.position_error_whole_run_m.rmse), numberText(method.step_ms_median, 3),
       numberText(method.step_ms_p99, 3), numberText(method.step_ms_max, 3)},
      css_class);
}

std::string yesNo(const std::optional<bool>& value) { return value ? (*value ? "yes" : "no") : kNoNumber; }

void addFact(std::string& rows, const std::string& name, const std::string& value)
{
  if (!value.empty()) rows += htmlRow({escapeHtml(name), escapeHtml(value)});
}

/// Ids as numbers where they are numbers: 2 before 10.
bool idBefore(const std::string& a, const std::string& b)
{
  const auto first = parseInteger(a), second = parseInteger(b);
  if (first && second) return *first < *second;
  return first.has_value() != second.has_value() ? first.has_value() : a < b;
}
}  // namespace

std::string trialFolder(int trial)
{
  const std::string digits = std::to_string(trial);
  return "trial_" + std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

std::string methodTable(const RunScore& score)
{
  const MethodScore* best = bestMethod(score);
  std::string rows;
  for (const MethodScore& method : score.methods) rows += methodRow(method, score, &method == best);
  return htmlTable({"method", "estimates", "available", "RMSE m", "95 % interval", "median m", "95 % m", "max m",
                    "heading RMSE deg", "whole run RMSE m", "ms per step", "99 % ms", "max ms"},
                   rows, "methods");
}

std::vector<std::string> landmarkOrder(const RunScore& score)
{
  std::vector<std::string> ids;
  for (const auto& [id, landmark] : score.landmarks) ids.push_back(id);
  std::stable_sort(ids.begin(), ids.end(), idBefore);
  return ids;
}

std::string landmarkTable(const RunScore& score)
{
  if (score.landmarks.empty()) return {};
  std::string rows;
  std::vector<std::string> ids = landmarkOrder(score);
  const std::size_t all = ids.size();
  ids.resize(std::min(all, kMostShownLandmarks));
  for (const std::string& id : ids)
  {
    const LandmarkScore& landmark = score.landmarks.at(id);
    const std::string warning = landmarkWarning(landmark);
    rows +=
        htmlRow({escapeHtml(id), countText(landmark.seen), numberText(landmark.associated, 1),
                 percentText(landmark.inlier_rate), numberText(landmark.residual_mean, 2),
                 numberText(landmark.residual_std, 2), warning.empty() ? "" : element("span", "badge warn", warning)},
                warning.empty() ? "" : "warned");
  }
  const std::string table = htmlTable(
      {"landmark", "seen", "associated", "inlier rate", "residual mean / σ", "residual std / σ", "warning"}, rows);
  if (ids.size() == all) return table;
  return table + element("p", "note", std::to_string(all - ids.size()) + " more landmarks are in summary.json.");
}

std::string observationTable(const RunContext& context)
{
  if (context.observations.empty()) return {};
  std::string rows;
  for (const auto& [name, count] : context.observations)
    rows += htmlRow(
        {escapeHtml(name), std::to_string(count.total), std::to_string(count.used), std::to_string(count.ignored)},
        count.used == 0 ? "ignored" : "");
  return htmlTable({"observation class", "total", "used", "ignored"}, rows);
}

std::string filterTable(const RunScore& score)
{
  const FilterScore& f = score.filter;
  if (!f.particles_median && !f.nees_mean) return {};
  std::string rows;
  addFact(rows, "particles (min, median, max)",
          countText(f.particles_min) + ", " + countText(f.particles_median) + ", " + countText(f.particles_max));
  addFact(rows, "NEES, mean (95 % band for independent errors)",
          numberText(f.nees_mean, 2) + " (" + numberText(f.nees_band_low, 2) + " to " +
              numberText(f.nees_band_high, 2) + ")");
  addFact(rows, "lowest effective sample ratio", numberText(f.effective_sample_ratio_min, 4));
  addFact(rows, "steps with verdict lost", countText(f.lost_steps));
  addFact(rows, "reseeds", countText(f.reseeds));
  if (f.late_estimates)
    addFact(rows, "estimates finished in a later step (most steps)",
            countText(f.late_estimates) + " (" + countText(f.most_steps_late) + ")");
  for (const auto& [name, bias] : f.biases)
    addFact(rows, "final " + name, numberText(bias.mean, 4) + " ± " + numberText(bias.std, 4));
  if (score.limit.position_rmse_m)
    addFact(rows, "posterior Cramér-Rao bound",
            magnitudeText(score.limit.position_rmse_m) + " m, " + numberText(score.limit.heading_rmse_deg, 2) + " deg");
  return htmlTable({"quantity", "value"}, rows, "facts");
}

std::string trialTable(const RunScore& score)
{
  std::string rows;
  for (const TrialScore& trial : score.trials)
  {
    const std::string folder = trialFolder(trial.trial);
    const bool bad = trial.verdict == Verdict::lost || trial.success == false;
    rows += htmlRow(
        {"<a href=\"" + folder + "/report.html\">" + folder + "</a>", std::to_string(trial.seed), yesNo(trial.success),
         element("span", std::string("badge ") + toString(trial.verdict), toString(trial.verdict)),
         magnitudeText(trial.rmse), numberText(trial.converged_at_s, 1)},
        bad ? "warned" : "");
  }
  return htmlTable({"trial", "seed", "success", "verdict", "RMSE m", "converged after s"}, rows);
}

std::string spellTable(const RunScore& score)
{
  constexpr std::size_t kShown = 8;
  const SpellsNotOk spells = spellsNotOk(score, kShown);
  std::string rows;
  for (const VerdictSpell& spell : spells.longest)
    rows += htmlRow({spanText(spell),
                     element("span", std::string("badge ") + toString(spell.verdict), toString(spell.verdict)),
                     escapeHtml(spell.reason)});
  if (rows.empty()) return {};
  if (spells.others > 0) rows += htmlRow({std::to_string(spells.others) + " shorter ones", "", ""});
  return htmlTable({"from start of log", "verdict", "reason that held longest"}, rows, "spells");
}

std::string provenanceTable(const RunContext& context, const RunScore& score)
{
  std::string rows;
  addFact(rows, "command", context.command_line);
  addFact(rows, "configuration", context.config_path);
  addFact(rows, "random seed", std::to_string(context.seed));
  addFact(rows, "version", context.version);
  addFact(rows, "built with", context.built_with);
  addFact(rows, "log", context.rawlog_path);
  addFact(rows, "log, SHA-256", context.rawlog_sha256);
  for (const InputFile& file : context.inputs)
  {
    if (file.role != "configuration") addFact(rows, file.role, file.path);
    addFact(rows, file.role + ", SHA-256", file.sha256);
  }
  addFact(rows, "log, entries and duration",
          std::to_string(context.rawlog_entries) + ", " + numberText(context.duration_s, 1) + " s");
  addFact(rows, "processor time, wall time",
          numberText(score.cost.cpu_s, 2) + " s, " + numberText(score.cost.wall_s, 2) + " s (" +
              magnitudeText(score.cost.realtime_factor) + " times real time)");
  addFact(rows, "peak memory", numberText(score.cost.peak_memory_mb, 0) + " MB");
  return htmlTable({"item", "value"}, rows, "facts provenance");
}
}  // namespace mrpt_ext
