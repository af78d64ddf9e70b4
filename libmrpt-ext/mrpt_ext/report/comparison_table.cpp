#include "mrpt_ext/report/comparison_table.h"

#include <algorithm>

#include "mrpt_ext/report/comparison_text.h"
#include "mrpt_ext/report/number_text.h"
#include "mrpt_ext/report/verdict_text.h"

namespace mrpt_ext
{
namespace
{
using Row = std::vector<std::string>;

const Row kTitles{"method", "estimates", "avail.", "RMSE", "median", "95 %", "worst", "heading", "ms per"};
const Row kUnits{"", "", "", "m", "m", "m", "m", "RMSE deg", "step"};

Row rowOf(const MethodScore& method, bool best)
{
  const std::string mark = best ? "* " : method.oracle ? "o " : "  ";
  const ErrorStatistics& position = method.position_error_m;
  return {mark + method.name,
          countText(method.estimates),
          percentText(method.availability),
          magnitudeText(position.rmse),
          magnitudeText(position.median),
          magnitudeText(position.p95),
          magnitudeText(position.max),
          numberText(method.heading_error_deg.rmse, 2),
          numberText(method.step_ms_median, 3)};
}

constexpr std::size_t kColumns = 100;

/// Names left-aligned, numbers right-aligned.
std::string aligned(const Row& row, const std::vector<std::size_t>& widths, const std::string& space)
{
  std::string line = row[0] + std::string(widths[0] - row[0].size(), ' ');
  for (std::size_t c = 1; c < row.size(); ++c) line += space + std::string(widths[c] - row[c].size(), ' ') + row[c];
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

std::string table(const std::vector<Row>& rows)
{
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::size_t width = 2 * (widths.size() - 1);
  for (const std::size_t w : widths) width += w;
  const std::string space(width <= kColumns ? 2 : 1, ' ');
  std::string text;
  for (const Row& row : rows) text += aligned(row, widths, space);
  return text;
}

/// Breaks lines at blanks to the width of the console.
std::string wrapped(const std::string& text)
{
  std::string lines;
  std::size_t begin = 0;
  while (text.size() - begin > kColumns)
  {
    const std::size_t blank = text.rfind(' ', begin + kColumns);
    if (blank == std::string::npos || blank <= begin) break;
    lines += text.substr(begin, blank - begin) + '\n';
    begin = blank + 1;
  }
  return lines + text.substr(begin) + '\n';
}

std::string legend(const RunScore& score, const MethodScore* best)
{
  std::string text;
  if (best) text += "* lowest position RMSE";
  const bool oracle = std::any_of(score.methods.begin(), score.methods.end(), [](const auto& m) { return m.oracle; });
  if (oracle) text += std::string(best ? "   " : "") + "o oracle: chose among its candidates with the truth";
  return text.empty() ? text : text + '\n';
}

/// What the budget of a step delayed; empty where it delayed nothing.
std::string latenessText(const FilterScore& filter)
{
  if (filter.late_estimates.value_or(0) == 0) return {};
  return countedText(filter.late_estimates, "estimate") + " of the particle filter came late, by up to " +
         countedText(filter.most_steps_late, "step") + ": the work exceeded step_budget_ms";
}

/// Limit and comparisons in words.
std::string conclusions(const RunScore& score)
{
  std::string text;
  if (const std::string limit = limitText(score); !limit.empty()) text += wrapped("limit: " + limit);
  for (const std::string& sentence : comparisonSentences(score)) text += wrapped(sentence);
  if (const std::string late = latenessText(score.filter); !late.empty()) text += wrapped(late);
  return text.empty() ? text : '\n' + text;
}
}  // namespace

std::string comparisonTable(const RunScore& score)
{
  const MethodScore* best = bestMethod(score);
  std::vector<Row> rows{kTitles, kUnits};
  rows[0][0] = "  " + rows[0][0];
  for (const MethodScore& method : score.methods) rows.push_back(rowOf(method, &method == best));
  std::string text = wrapped(outcomeText(score));
  if (const std::string split = detectionSplitText(score); !split.empty()) text += wrapped(split);
  if (score.interrupted) text += "Interrupted: the scores cover only the finished part.\n";
  return text + '\n' + table(rows) + legend(score, best) + conclusions(score) + '\n' +
         wrapped(std::string("verdict: ") + toString(score.verdict) +
                 (score.verdict_reason.empty() ? "" : " (" + score.verdict_reason + ")")) +
         verdictHistoryText(score);
}
}  // namespace mrpt_ext
