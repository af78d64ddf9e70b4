#include <gtest/gtest.h>

#include "results_table.h"
#include "sample.h"

namespace mrpt_ext::papers
{
TEST(ResultsTable, SaysWhatCameOut)
{
  EXPECT_EQ(outcomeText({.outcome = Outcome::reproduced}), "reproduced");
  EXPECT_EQ(outcomeText({.outcome = Outcome::reproduced, .reason = "in kind"}), "reproduced: in kind");
  EXPECT_EQ(outcomeText({.outcome = Outcome::differs, .reason = "it rained"}), "differs because it rained");
  EXPECT_EQ(outcomeText({.outcome = Outcome::input_missing, .reason = "the map"}),
            "not reproducible, input missing: the map");
}

TEST(ResultsTable, WritesMarkdownWithLinksFromItsOwnFolder)
{
  ResultSection section;
  section.title = "Table 1";
  section.scenarios = {"tests/papers/a.ini", "ini/b/c.ini"};
  section.paragraph = "What was measured.";
  section.rows.push_back({.what = "error", .paper = "1.0", .closed_form = "1.1", .trials = "7"});
  section.plain = {{"x", "y"}, {"1", "2"}};
  EXPECT_EQ(markdown(section),
            "## Table 1\n\n"
            "Scenarios: [`tests/papers/a.ini`](a.ini), [`ini/b/c.ini`](../../ini/b/c.ini)\n\n"
            "What was measured.\n\n"
            "|  | paper | same closed form here | our best estimator | limit (CRLB) | N | outcome |\n"
            "|---|---|---|---|---|---|---|\n"
            "| error | 1.0 | 1.1 | - | - | 7 | reproduced |\n\n"
            "| x | y |\n|---|---|\n| 1 | 2 |\n");
}

TEST(Sample, MeansSpreadsAndTexts)
{
  Sample sample;
  for (const double v : {1.0, 2.0, 3.0, 6.0}) sample.add(v);
  EXPECT_DOUBLE_EQ(sample.mean(), 3);
  EXPECT_DOUBLE_EQ(sample.median(), 2.5);
  EXPECT_NEAR(sample.spread(), std::sqrt(3.5), 1e-12);
  EXPECT_NEAR(sample.rms(), std::sqrt(12.5), 1e-12);
  EXPECT_EQ(sample.text(1), "3.0 ± 1.9");
  EXPECT_EQ(sample.text(0, 0.01), "300 ± 187");
  EXPECT_DOUBLE_EQ(sample.share([](double v) { return v > 1.5; }), 0.75);
}
}  // namespace mrpt_ext::papers
