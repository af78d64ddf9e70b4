#include "mrpt_ext/hypotheses/pruning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace mrpt_ext::test_pruning
{
namespace
{
/// A log-weight and where the hypothesis is.
using Hypothesis = std::pair<double, int>;
using Hypotheses = std::vector<Hypothesis>;

double logWeight(const Hypothesis& h) { return h.first; }
bool areNeighbours(const Hypothesis& a, const Hypothesis& b) { return std::abs(a.second - b.second) <= 1; }
}  // namespace

TEST(Pruning, SortsBestFirstAndKeepsTheOrderOfEquals)
{
  Hypotheses set{{-2, 1}, {0, 2}, {-2, 3}, {-1, 4}};
  sortByLogWeight(set, logWeight);
  EXPECT_EQ(set, (Hypotheses{{0, 2}, {-1, 4}, {-2, 1}, {-2, 3}}));
}

TEST(Pruning, DropsWhatIsTooUnlikely)
{
  Hypotheses set{{10, 1}, {7, 2}, {5, 3}, {4.9, 4}, {0, 5}};
  pruneUnlikely(set, 5, logWeight);
  EXPECT_EQ(set, (Hypotheses{{10, 1}, {7, 2}, {5, 3}}));
  Hypotheses none;
  pruneUnlikely(none, 5, logWeight);
  EXPECT_TRUE(none.empty());
}

TEST(Pruning, KeepsTheBestOfDuplicates)
{
  Hypotheses set{{3, 10}, {2, 11}, {1, 12}, {0, 20}};
  mergeSame(set, areNeighbours);
  EXPECT_EQ(set, (Hypotheses{{3, 10}, {1, 12}, {0, 20}})) << "a dropped duplicate has none itself";
}

TEST(Pruning, KeepsAtMostSoMany)
{
  Hypotheses set{{3, 10}, {2, 11}, {1, 12}, {0, 20}};
  mergeSame(set, areNeighbours, 2);
  EXPECT_EQ(set, (Hypotheses{{3, 10}, {1, 12}}));
}
}  // namespace mrpt_ext::test_pruning
