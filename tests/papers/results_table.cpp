#include "results_table.h"

namespace mrpt_ext::papers
{
namespace
{
std::string line(const PlainRow& cells)
{
  std::string text = "|";
  for (const std::string& cell : cells) text.append(" ").append(cell).append(" |");
  return text.append("\n");
}

/// [name](path from tests/papers).
std::string link(const std::string& scenario)
{
  const std::string here = "tests/papers/";
  const bool ours = scenario.starts_with(here);
  std::string text = "[`";
  text.append(scenario).append("`](");
  text.append(ours ? scenario.substr(here.size()) : std::string("../../").append(scenario));
  return text.append(")");
}
}  // namespace

std::string outcomeText(const ResultRow& row)
{
  switch (row.outcome)
  {
    case Outcome::reproduced:
      return row.reason.empty() ? "reproduced" : "reproduced: " + row.reason;
    case Outcome::differs:
      return "differs because " + row.reason;
    case Outcome::input_missing:
      return "not reproducible, input missing: " + row.reason;
  }
  return {};
}

std::string markdownTable(const std::vector<PlainRow>& rows)
{
  if (rows.empty()) return {};
  std::string text = line(rows.front()) + "|";
  for (std::size_t i = 0; i < rows.front().size(); ++i) text += "---|";
  text += "\n";
  for (std::size_t r = 1; r < rows.size(); ++r) text += line(rows[r]);
  return text;
}

std::string markdown(const ResultSection& section)
{
  std::string text = "## ";
  text.append(section.title).append("\n\n");
  if (!section.scenarios.empty())
  {
    text += section.scenarios.size() > 1 ? "Scenarios: " : "Scenario: ";
    for (std::size_t i = 0; i < section.scenarios.size(); ++i) text += (i > 0 ? ", " : "") + link(section.scenarios[i]);
    text += "\n\n";
  }
  text += section.paragraph + "\n";
  if (!section.rows.empty())
  {
    std::vector<PlainRow> cells{
        {"", "paper", "same closed form here", "our best estimator", "limit (CRLB)", "N", "outcome"}};
    for (const ResultRow& row : section.rows)
      cells.push_back({row.what, row.paper, row.closed_form, row.best, row.limit, row.trials, outcomeText(row)});
    text.append("\n").append(markdownTable(cells));
  }
  if (!section.plain.empty()) text.append("\n").append(markdownTable(section.plain));
  return text;
}
}  // namespace mrpt_ext::papers
