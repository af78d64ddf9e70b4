#include "mrpt_ext/correspondence/hitting_set.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_hitting_set
{
namespace
{
using Triples = std::vector<std::array<int, 3>>;

Triples randomTriples(int numbers, int count, RandomStream& random)
{
  Triples triples;
  while (static_cast<int>(triples.size()) < count)
  {
    std::array<int, 3> t{};
    for (int& n : t) n = static_cast<int>(random.below(static_cast<std::size_t>(numbers)));
    if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triples.push_back(t);
  }
  return triples;
}

bool hitsAll(const std::vector<int>& members, const Triples& triples)
{
  const auto hit = [&](const auto& t)
  { return std::any_of(t.begin(), t.end(), [&](int n) { return std::count(members.begin(), members.end(), n) > 0; }); };
  return std::all_of(triples.begin(), triples.end(), hit);
}

/// By trying all sets.
std::size_t smallestByTrial(int numbers, const Triples& triples)
{
  std::size_t least = static_cast<std::size_t>(numbers);
  for (unsigned set = 0; set < 1U << numbers; ++set)
  {
    std::vector<int> members;
    for (int n = 0; n < numbers; ++n)
      if ((set >> n & 1U) != 0) members.push_back(n);
    if (members.size() < least && hitsAll(members, triples)) least = members.size();
  }
  return least;
}
}  // namespace

TEST(HittingSet, IsTheSmallestOne)
{
  RandomStream random(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int numbers = 4 + static_cast<int>(random.below(7));
    const Triples triples = randomTriples(numbers, static_cast<int>(random.below(20)), random);
    WorkBudget budget;
    const HittingSet found = smallestHittingSet(triples, 0, budget);
    EXPECT_TRUE(hitsAll(found.members, triples));
    EXPECT_EQ(found.members.size(), smallestByTrial(numbers, triples));
    EXPECT_EQ(found.least, found.members.size());
  }
}

TEST(HittingSet, WithoutTheWorkForItAWholeSetAndALowerBoundRemain)
{
  RandomStream random(2);
  for (int trial = 0; trial < 50; ++trial)
  {
    const int numbers = 10;
    const Triples triples = randomTriples(numbers, 60, random);
    WorkBudget budget(static_cast<std::uint64_t>(random.below(5000)));
    const HittingSet found = smallestHittingSet(triples, 0, budget);
    EXPECT_TRUE(hitsAll(found.members, triples));
    EXPECT_LE(found.least, smallestByTrial(numbers, triples));
    EXPECT_GE(found.members.size(), found.least);
  }
}

TEST(HittingSet, OfHundredsOfTriplesEndsWithItsBudget)
{
  RandomStream random(3);
  const Triples triples = randomTriples(300, 2000, random);
  WorkBudget budget(1'000'000);
  const HittingSet found = smallestHittingSet(triples, 0, budget);
  EXPECT_TRUE(budget.exhausted());
  EXPECT_TRUE(hitsAll(found.members, triples));
  EXPECT_GT(found.least, 50u);  // disjoint triples alone
}
}  // namespace mrpt_ext::test_hitting_set
