#include <gtest/gtest.h>

#include "paper_settings.h"
#include "sections.h"

namespace mrpt_ext::papers::test_tree_table
{
namespace
{
const TreeExperiment& fewMaps()
{
  static const TreeExperiment kTree = runTreeExperiment(paperSettings("paper-000-table-1", {"Experiment.trials=30"}));
  return kTree;
}
}  // namespace

TEST(PaperTreeTable, CountsAsThePaperDoes)
{
  const std::vector<std::uint64_t> printed{11880, 95040, 665280, 3991680};
  const auto& results = fewMaps().results;
  ASSERT_EQ(results.size(), printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) EXPECT_EQ(results[i].total_paths, printed[i]);
  // Some thousands, and hardly more after the fifth bearing.
  EXPECT_GT(results[0].paper.examined.median(), 1500);
  EXPECT_LT(results[3].paper.examined.median(), 15000);
  EXPECT_LT(results[3].paper.examined.mean(), 1.1 * results[1].paper.examined.mean());
}

TEST(PaperTreeTable, SolutionsBecomeFewerAndOursKeepTheTruth)
{
  const auto& results = fewMaps().results;
  for (std::size_t i = 1; i < results.size(); ++i)
  {
    EXPECT_LT(results[i].ours.solutions.mean(), results[i - 1].ours.solutions.mean());
    EXPECT_LT(results[i].ours.examined.mean(), results[i].paper.examined.mean());
    EXPECT_GT(results[i].ours.truth_found, 0.9);
    EXPECT_LT(results[i].paper.truth_found, results[i].ours.truth_found);
  }
}

TEST(PaperTreeTable, SameSeedSameText)
{
  const std::vector<std::string> few{"Experiment.trials=3"};
  const auto text = [&] { return markdown(sectionTree(runTreeExperiment(paperSettings("paper-000-table-1", few)))); };
  EXPECT_EQ(text(), text());
}
}  // namespace mrpt_ext::papers::test_tree_table
