#pragma once

#include <string>
#include <vector>

namespace mrpt_ext::papers
{
/// What came out of repeating something that a paper prints.
enum class Outcome
{
  reproduced,
  differs,       ///< the reason follows
  input_missing  ///< what the paper does not give, or we do not have, follows
};

/// A printed figure beside ours; texts, since units and decimals differ from row to row.
struct ResultRow
{
  std::string what;
  std::string paper = "-";        ///< as printed
  std::string closed_form = "-";  ///< the same formulas in our simulation, with their spread
  std::string best = "-";         ///< our best estimator on the same measurements
  std::string limit = "-";        ///< Cramer-Rao
  std::string trials;             ///< N
  Outcome outcome = Outcome::reproduced;
  std::string reason;  ///< ends the sentence that the outcome begins
};

/// A row of figures without the papers' columns.
using PlainRow = std::vector<std::string>;

/// A table with its heading, what was measured and why it agrees or not, and the .ini files it comes from.
struct ResultSection
{
  std::string title;
  std::vector<std::string> scenarios;  ///< paths from the root of the project
  std::string paragraph;
  std::vector<ResultRow> rows;
  std::vector<PlainRow> plain;  ///< a further table, its header first
};

/// "reproduced", "differs because ..." or "not reproducible: ...".
[[nodiscard]] std::string outcomeText(const ResultRow& row);

/// A Markdown table, the header first.
[[nodiscard]] std::string markdownTable(const std::vector<PlainRow>& rows);

/// The section as Markdown, links relative to tests/papers.
[[nodiscard]] std::string markdown(const ResultSection& section);
}  // namespace mrpt_ext::papers
