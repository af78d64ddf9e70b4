#pragma once

#include <cstdint>

namespace mrpt_ext
{
/// Operations (work_budget.h) that this thread has done, counted by the innermost loops themselves, whoever runs them:
/// what the tests hold the budgets against. A loop over something counts once for all its turns.
class WorkCounter
{
 public:
  static void add(std::uint64_t operations) { count += operations; }
  [[nodiscard]] static std::uint64_t done() { return count; }

 private:
  static inline thread_local std::uint64_t count = 0;
};
}  // namespace mrpt_ext
