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

std::string trialText(const RunScore& score)
{
  const TrialScore& trial = score.trials.front();
  if (!score.judged_method) return "No method tracks the pose: all estimates count.";
  if (score.interrupted) return "Interrupted: the finished part is scored, success is not known.";
  if (!trial.success) return "No ground truth within the log: no errors.";
  const std::string limits =
      numberText(score.limits.within_m, 2) + " m / " + numberText(score.limits.within_deg, 0) + " deg";
  if (!trial.converged_at_s)
  {
    OptionalNumber whole;
    for (const MethodScore& method : score.methods)
      if (method.name == *score.judged_method) whole = method.position_error_whole_run_m.rmse;
    return *score.judged_method + " never stayed within " + limits +
           " for 5 s: no errors after convergence (whole run: RMSE " + magnitudeText(whole) + " m).";
  }
  return *score.judged_method + " converged after " + numberText(trial.converged_at_s, 1) + " s (within " + limits +
         "); " + (*trial.success ? "success." : "no success: converged too late, or later outside for more than 10 s.");
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

std::string outcomeText(const RunScore& score)
{
  if (score.trials.empty()) return "No trial was finished.";
  return score.trials.size() == 1 ? trialText(score) : trialsText(score);
}
}  // namespace mrpt_ext
