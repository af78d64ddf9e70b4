#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>

namespace mrpt_ext
{
/// The work that searches may do, counted in operations: unlike a limit in seconds, it ends a search of the same input
/// at the same point on every machine. One operation is about a nanosecond, as comparing a triple of landmarks with a
/// triple of bearings; a loop over something costlier spends more than one per turn.
///
/// Tables that are built once per map are not counted: their size is limited.
///
/// The innermost loop of every search asks it, so that a search also ends soon after `stop` is set (a signal).
class WorkBudget
{
 public:
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

  explicit WorkBudget(std::uint64_t operations = kUnlimited, const std::atomic<bool>* stop = nullptr)
      : limit_(operations), stop_(stop)
  {
  }
  /// A share, in (0, 1], of what is left of another budget, which must outlive it and is spent with it.
  WorkBudget(WorkBudget& whole, double share)
      : limit_(whole.limit_ == kUnlimited ? kUnlimited
                                          : static_cast<std::uint64_t>(share * static_cast<double>(whole.left()))),
        stop_(whole.stop_),
        whole_(&whole)
  {
  }

  /// At most so many operations of another budget, likewise.
  [[nodiscard]] static WorkBudget partOf(WorkBudget& whole, std::uint64_t operations)
  {
    WorkBudget part(std::min(operations, whole.left()), whole.stop_);
    part.whole_ = &whole;
    return part;
  }

  /// Counts operations that are due; false when they must not be done any more. Of those that are refused no more are
  /// counted than were left: the whole keeps what a share was refused.
  bool spend(std::uint64_t operations)
  {
    const std::uint64_t counted = std::min(operations, left());
    spent_ += counted;
    if (whole_ != nullptr) whole_->spend(counted);
    return !exhausted();
  }
  [[nodiscard]] bool exhausted() const { return spent_ >= limit_ || isStopped() || (whole_ && whole_->exhausted()); }
  /// True when it was ended from outside.
  [[nodiscard]] bool isStopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  /// Never beyond the limit.
  [[nodiscard]] std::uint64_t spent() const { return spent_; }
  [[nodiscard]] std::uint64_t limit() const { return limit_; }
  [[nodiscard]] std::uint64_t left() const { return limit_ - std::min(limit_, spent_); }

 private:
  std::uint64_t limit_, spent_ = 0;
  const std::atomic<bool>* stop_;
  WorkBudget* whole_ = nullptr;
};
}  // namespace mrpt_ext
