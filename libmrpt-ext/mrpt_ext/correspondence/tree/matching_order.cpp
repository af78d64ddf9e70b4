#include "mrpt_ext/correspondence/tree/matching_order.h"

#include <algorithm>
#include <array>

namespace mrpt_ext
{
namespace
{
constexpr double kNearlyAsSpread = 0.6;  // of the best triple's gap

double gapBetween(double a, double b) { return std::abs(wrap(a - b)); }

struct Triple
{
  std::array<int, 3> index{0, 1, 2};
  double gap = -1;
  double combinations = 0;
};

/// The most spread triple of these bearings, or a nearly as spread one with fewer combinations of landmarks.
Triple firstTriple(const InterpretationProblem& problem, const std::vector<int>& of)
{
  const auto bearing = [&](int i) { return problem.bearings[static_cast<std::size_t>(i)]; };
  const auto choices = [&](int i) { return static_cast<double>(problem.allowed[static_cast<std::size_t>(i)].size()); };
  std::vector<Triple> triples;
  double widest = 0;
  for (auto i = of.begin(); i != of.end(); ++i)
    for (auto j = i + 1; j != of.end(); ++j)
    {
      const double gap_ij = gapBetween(bearing(*i), bearing(*j));
      if (gap_ij < kNearlyAsSpread * widest) continue;
      for (auto k = j + 1; k != of.end(); ++k)
      {
        const double gap =
            std::min({gap_ij, gapBetween(bearing(*i), bearing(*k)), gapBetween(bearing(*j), bearing(*k))});
        if (gap < kNearlyAsSpread * widest) continue;
        widest = std::max(widest, gap);
        triples.push_back({{*i, *j, *k}, gap, choices(*i) * choices(*j) * choices(*k)});
      }
    }
  Triple best;
  for (const Triple& t : triples)
  {
    if (t.gap < kNearlyAsSpread * widest) continue;
    const bool fewer = t.combinations < best.combinations;
    if (best.gap < 0 || fewer || (t.combinations == best.combinations && t.gap > best.gap)) best = t;
  }
  return best;
}

/// The bearings in `last` come after all others, in their order.
std::vector<int> spreadOrder(const InterpretationProblem& problem, std::span<const int> last = {})
{
  std::vector<int> rest;
  for (int i = 0; i < static_cast<int>(problem.bearings.size()); ++i)
    if (std::find(last.begin(), last.end(), i) == last.end()) rest.push_back(i);
  const Triple first = firstTriple(problem, rest);
  std::vector<int> order(first.index.begin(), first.index.end());
  std::erase_if(rest, [&](int i) { return std::find(order.begin(), order.end(), i) != order.end(); });
  const auto isolation = [&](int i)
  {
    double gap = kPi;
    for (const int chosen : order)
      gap = std::min(gap, gapBetween(problem.bearings[static_cast<std::size_t>(i)],
                                     problem.bearings[static_cast<std::size_t>(chosen)]));
    return gap;
  };
  while (!rest.empty())
  {
    const auto next =
        std::max_element(rest.begin(), rest.end(), [&](int a, int b) { return isolation(a) < isolation(b); });
    order.push_back(*next);
    rest.erase(next);
  }
  order.insert(order.end(), last.begin(), last.end());
  return order;
}
}  // namespace

std::vector<MatchingOrder> matchingOrders(const InterpretationProblem& problem)
{
  const std::size_t count = problem.bearings.size();
  const std::size_t max_skipped = count - static_cast<std::size_t>(problem.minimumMatched());
  MatchingOrder order{spreadOrder(problem), 0, 0, max_skipped};
  if (max_skipped != 1 || count < 6) return {order};
  order.skip_from = 3;
  return {order, {spreadOrder(problem, std::span(order.bearings).first(3)), count - 3, 1, 1}};
}
}  // namespace mrpt_ext
