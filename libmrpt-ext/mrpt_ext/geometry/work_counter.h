#pragma once

#include <cstdint>
#include <utility>

namespace mrpt_ext
{
/// Who is told of operations while they are done, and may let the work wait (sliced_work.h).
class WorkObserver
{
 public:
  virtual void spend(std::uint64_t operations) = 0;

 protected:
  ~WorkObserver() = default;
};

/// Operations (work_budget.h) that this thread has done, counted by the innermost loops themselves, whoever runs them:
/// what the tests hold the budgets against, and where a step that takes too long waits. A loop over something counts
/// once for all its turns.
class WorkCounter
{
 public:
  static void add(std::uint64_t operations)
  {
    count += operations;
    if (observer != nullptr) observer->spend(operations);
  }
  [[nodiscard]] static std::uint64_t done() { return count; }
  /// Of what this thread does from now on; none for null.
  static void observeBy(WorkObserver* by) { observer = by; }

  /// While it lives the observer is told nothing; at its end, of all that was done meanwhile: for work that must not
  /// wait, since other threads take part in it.
  class Undivided
  {
   public:
    Undivided() = default;
    Undivided(const Undivided&) = delete;
    Undivided& operator=(const Undivided&) = delete;
    ~Undivided()
    {
      observer = told_;
      if (observer != nullptr) observer->spend(count - before_);
    }

   private:
    WorkObserver* told_ = std::exchange(observer, nullptr);
    std::uint64_t before_ = count;
  };

 private:
  static inline thread_local std::uint64_t count = 0;
  static inline thread_local WorkObserver* observer = nullptr;
};
}  // namespace mrpt_ext
