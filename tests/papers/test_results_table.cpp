#include <gtest/gtest.h>

#include "errata.h"
#include "mrpt_ext/files/text_file.h"
#include "results_table.h"
#include "sample.h"

namespace mrpt_ext::papers::test_results_table
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

// The page itself takes a minute to measure; what it must at least tell is checked without that.
TEST(ResultsPage, NamesEveryScenarioAndEveryErratum)
{
  const std::string page = readTextFile(std::string(MRPT_EXT_SOURCE_DIR) + "/tests/papers/RESULTS.md");
  for (const Erratum& erratum : allErrata())
    EXPECT_NE(page.find("`" + testName(erratum) + "`"), std::string::npos) << erratum;
  for (const std::string name : {"000-table-1", "001-lattice", "001-drive", "001-drive-turned", "004-ranges",
                                 "004-located", "004-drive", "004-open-study"})
    EXPECT_NE(page.find("(paper-" + name + ".ini)"), std::string::npos) << name;
  for (const std::string table :
       {"Paper 000, table 1", "Paper 001, table 1", "Paper 001, table 2", "Paper 001, table 3", "Paper 001, table 4",
        "Paper 004, tables 1 and 2", "Paper 004, tables 3 and 4"})
    EXPECT_NE(page.find("## " + table), std::string::npos) << table;
  EXPECT_NE(page.find("cmake --build build --target papers"), std::string::npos);
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
}  // namespace mrpt_ext::papers::test_results_table
