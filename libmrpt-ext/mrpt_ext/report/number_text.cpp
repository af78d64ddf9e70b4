#include "mrpt_ext/report/number_text.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
bool exists(const OptionalNumber& number) { return number && std::isfinite(*number); }

std::string successText(const RunScore& score, const TrialScore& trial)
{
  const std::string judged_at =
      score.truth_is_sparse ? " Judged at the " + std::to_string(score.truth_stamps) + " stamps of a sparse truth."
                            : "";
  if (!trial.success)
    return "success is not known: the truth begins more than " + numberText(score.limits.max_convergence_s, 0) +
           " s after the log." + judged_at;
  if (*trial.success) return "success." + judged_at;
  const bool late = *trial.converged_at_s > score.limits.max_convergence_s;
  return (late ? "no success: converged too late." : "no success: later outside for more than 10 s.") + judged_at;
}

constexpr double kStampInterval = 1;  // [s] between the stamps at which errors are known

/// The filter judges itself without the truth, so that it may be right for some time before it says so.
std::string laterOkText(const RunScore& score, double converged_at)
{
  if (!score.verdict_spells) return {};
  for (const VerdictSpell& spell : *score.verdict_spells)
    if (spell.verdict == Verdict::ok)
      return spell.from > converged_at + kStampInterval
                 ? " Its verdict, which knows no truth, is ok from " + numberText(spell.from, 1) + " s on."
                 : "";
  return {};
}

/// A verdict that was wrong is nothing to hide, however short.
std::string wrongOkText(const RunScore& score)
{
  if (!exists(score.filter.ok_outside) || *score.filter.ok_outside == 0) return {};
  return " Estimates outside of these limits with verdict ok: " + countText(score.filter.ok_outside) + ".";
}

std::string trialText(const RunScore& score)
{
  const TrialScore& trial = score.trials.front();
  if (!score.judged_method) return "No method tracks the pose: all estimates count.";
  if (score.interrupted) return "Interrupted: the finished part is scored, success is not known.";
  if (score.truth_stamps == 0) return "No ground truth within the log: no errors.";
  const std::string limits =
      numberText(score.limits.within_m, 2) + " m / " + numberText(score.limits.within_deg, 0) + " deg";
  if (!trial.converged_at_s && !trial.success)
    return "Success is not known: the " + std::to_string(score.truth_stamps) +
           " stamps of the truth begin too late, or span too short a time.";
  if (!trial.converged_at_s)
  {
    OptionalNumber whole;
    for (const MethodScore& method : score.methods)
      if (method.name == *score.judged_method) whole = method.position_error_whole_run_m.rmse;
    if (!exists(whole)) return *score.judged_method + " has no estimate at the times of the truth: no errors.";
    return *score.judged_method + " never stayed within " + limits +
           " for 5 s: no errors after convergence (whole run: RMSE " + magnitudeText(whole) + " m)." +
           wrongOkText(score);
  }
  return *score.judged_method + " converged after " + numberText(trial.converged_at_s, 1) + " s (within " + limits +
         " of the truth); " + successText(score, trial) + laterOkText(score, *trial.converged_at_s) +
         wrongOkText(score);
}

std::string trialsText(const RunScore& score)
{
  std::size_t lost = 0;
  std::vector<double> rmse;
  for (const TrialScore& trial : score.trials)
  {
    lost += trial.verdict == Verdict::lost ? 1 : 0;
    if (trial.rmse) rmse.push_back(*trial.rmse);
  }
  std::string text = std::to_string(score.trials.size()) + " trials: success rate " +
                     numberText(score.success_rate, 2) + ", " + std::to_string(lost) + " lost";
  if (score.judged_method && !rmse.empty())
    text += "; position RMSE of " + *score.judged_method + " from " + magnitudeText(quantile(rmse, 0)) + " to " +
            magnitudeText(quantile(rmse, 1)) + " m, median " + magnitudeText(median(rmse)) + " m";
  return text + ". Numbers are medians over the trials.";
}
}  // namespace

std::string numberText(const OptionalNumber& number, int decimals)
{
  return exists(number) ? fixedText(*number, decimals) : kNoNumber;
}

std::string magnitudeText(const OptionalNumber& number)
{
  if (!exists(number)) return kNoNumber;
  const double size = std::abs(*number);
  return fixedText(*number, size < 9.9995 ? 3 : size < 99.995 ? 2 : size < 999.95 ? 1 : 0);
}

std::string percentText(const OptionalNumber& share)
{
  if (!exists(share)) return kNoNumber;
  const double percent = 100 * *share;
  if (*share > 0 && percent < 0.5) return "<1 %";
  if (*share < 1 && percent >= 99.5) return ">99 %";
  return fixedText(percent, 0) + " %";
}

std::string countText(const OptionalNumber& number)
{
  return exists(number) ? fixedText(*number, *number == std::floor(*number) ? 0 : 1) : kNoNumber;
}

std::string countedText(const OptionalNumber& number, const std::string& what)
{
  return countText(number) + ' ' + what + (number == 1 ? "" : "s");
}

const MethodScore* bestMethod(const RunScore& score)
{
  const MethodScore* best = nullptr;
  for (const MethodScore& method : score.methods)
  {
    const OptionalNumber& rmse = method.position_error_m.rmse;
    if (method.oracle || !rmse) continue;
    if (!best || *rmse < *best->position_error_m.rmse) best = &method;
  }
  return best;
}

const MethodScore* judgedScore(const RunScore& score)
{
  for (const MethodScore& method : score.methods)
    if (score.judged_method && method.name == *score.judged_method) return &method;
  return nullptr;
}

std::string detectionSplitText(const RunScore& score)
{
  const MethodScore* judged = judgedScore(score);
  if (!judged || !judged->position_error_m.rmse) return {};
  const OptionalNumber &seeing = judged->position_error_with_detections_m.rmse,
                       &blind = judged->position_error_blind_m.rmse;
  std::string text = judged->name + ": position RMSE ";
  if (seeing) text += magnitudeText(seeing) + " m with detections";
  if (blind)
    text += (seeing ? ", " : "") + magnitudeText(blind) + " m without any for more than " + numberText(kBlindAfter, 0) +
            " s";
  return text;
}

std::string outcomeText(const RunScore& score)
{
  if (score.trials.empty()) return "No trial was finished.";
  return score.trials.size() == 1 ? trialText(score) : trialsText(score);
}
}  // namespace mrpt_ext
