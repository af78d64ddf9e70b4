#include "mrpt_ext/correspondence/hitting_set.h"

#include <algorithm>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
using Members = std::array<int, 3>;
using Marks = std::vector<char>;  // by number

bool isMarked(const Members& triple, const Marks& marks)
{
  return std::any_of(triple.begin(), triple.end(), [&](int n) { return marks[static_cast<std::size_t>(n)] != 0; });
}

void mark(const Members& triple, Marks& marks)
{
  for (const int n : triple) marks[static_cast<std::size_t>(n)] = 1;
}

std::size_t numbersIn(std::span<const Members> triples)
{
  int largest = -1;
  for (const Members& triple : triples) largest = std::max(largest, *std::max_element(triple.begin(), triple.end()));
  return static_cast<std::size_t>(largest) + 1;
}

/// Mutually disjoint triples among those without a marked number: each needs a further member.
std::size_t membersNeeded(std::span<const Members> triples, Marks marks)
{
  std::size_t packed = 0;
  for (const Members& triple : triples)
    if (!isMarked(triple, marks))
    {
      mark(triple, marks);
      ++packed;
    }
  return packed;
}

/// Branch and bound for a hitting set of at most `size` members.
class BoundedSet
{
 public:
  BoundedSet(std::span<const Members> triples, std::size_t size, WorkBudget& budget)
      : triples_(triples), size_(size), budget_(budget), hit_(numbersIn(triples), 0)
  {
  }

  bool extend()
  {
    const auto open = std::find_if(triples_.begin(), triples_.end(), [&](const auto& t) { return !isMarked(t, hit_); });
    if (open == triples_.end()) return true;
    WorkCounter::add(6 * triples_.size() + hit_.size());
    if (!budget_.spend(6 * triples_.size() + hit_.size())) return false;
    if (members_.size() + membersNeeded(triples_, hit_) > size_) return false;
    for (const int member : *open)
    {
      members_.push_back(member);
      hit_[static_cast<std::size_t>(member)] = 1;
      if (extend()) return true;
      hit_[static_cast<std::size_t>(member)] = 0;
      members_.pop_back();
    }
    return false;
  }

  [[nodiscard]] std::vector<int> take() { return std::move(members_); }

 private:
  std::span<const Members> triples_;
  std::size_t size_;
  WorkBudget& budget_;
  Marks hit_;
  std::vector<int> members_;
};

/// The number in most of the triples that are left, again and again.
std::vector<int> greedyHittingSet(std::span<const Members> triples)
{
  std::vector<int> members, count(numbersIn(triples));
  std::vector<Members> left(triples.begin(), triples.end());
  while (!left.empty())
  {
    std::fill(count.begin(), count.end(), 0);
    for (const Members& triple : left)
      for (const int n : triple) ++count[static_cast<std::size_t>(n)];
    const int most = static_cast<int>(std::max_element(count.begin(), count.end()) - count.begin());
    members.push_back(most);
    std::erase_if(left, [&](const Members& t) { return std::find(t.begin(), t.end(), most) != t.end(); });
  }
  return members;
}
}  // namespace

HittingSet smallestHittingSet(std::span<const Members> triples, std::size_t known_least, WorkBudget& budget)
{
  std::size_t least = std::max(known_least, membersNeeded(triples, Marks(numbersIn(triples), 0)));
  for (;; ++least)
  {
    BoundedSet bounded(triples, least, budget);
    if (bounded.extend()) return {bounded.take(), least};
    if (budget.exhausted()) return {greedyHittingSet(triples), least};
  }
}
}  // namespace mrpt_ext
