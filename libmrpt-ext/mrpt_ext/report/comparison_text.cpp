#include "mrpt_ext/report/comparison_text.h"

#include "mrpt_ext/evaluation/odometry_alignment.h"
#include "mrpt_ext/report/number_text.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSame = 0.05;  // relative difference of RMSE

std::string costText(const OptionalNumber& ratio)
{
  if (!ratio || !(*ratio > 0)) return "";
  if (*ratio >= 1) return ", at " + numberText(ratio, *ratio < 10 ? 1 : 0) + " times the cost";
  const double share = 1 / *ratio;
  return ", at 1/" + numberText(share, share < 10 ? 1 : 0) + " of the cost";
}

std::string sentence(const MethodComparison& c)
{
  const std::string relation = c.ratio_low > 1 - kSame && c.ratio_high < 1 + kSame ? " is as accurate as "
                               : c.ratio_high < 1                                  ? " is more accurate than "
                               : c.ratio_low > 1                                   ? " is less accurate than "
                                                 : " is not distinguishable in accuracy from ";
  return c.method + relation + c.reference + costText(c.cost_ratio) + ": RMSE " + numberText(c.rmse_ratio, 2) +
         " times (95 %: " + numberText(c.ratio_low, 2) + " to " + numberText(c.ratio_high, 2) + ")";
}
}  // namespace

std::vector<std::string> comparisonSentences(const RunScore& score)
{
  std::vector<std::string> sentences;
  for (const MethodComparison& comparison : score.comparisons) sentences.push_back(sentence(comparison));
  return sentences;
}

std::string limitText(const RunScore& score)
{
  if (!score.limit.why_none.empty()) return "no posterior Cramer-Rao bound: " + score.limit.why_none;
  if (!score.limit.position_rmse_m || !score.judged_method) return {};
  std::string text = "posterior Cramer-Rao bound: position RMSE " + magnitudeText(score.limit.position_rmse_m) +
                     " m, heading " + numberText(score.limit.heading_rmse_deg, 2) + " deg";
  for (const MethodScore& method : score.methods)
    if (method.continuous && !method.oracle && method.name != kOdometryMethod && method.position_error_m.rmse)
      text += "; " + method.name + " " + numberText(*method.position_error_m.rmse / *score.limit.position_rmse_m, 2) +
              " times the bound";
  return text;
}
}  // namespace mrpt_ext
