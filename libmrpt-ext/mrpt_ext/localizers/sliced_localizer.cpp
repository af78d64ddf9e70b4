#include "mrpt_ext/localizers/sliced_localizer.h"

#include <algorithm>
#include <utility>

namespace mrpt_ext
{
namespace
{
// An operation takes about a nanosecond (work_budget.h); in steps of the recordings up to two, on a busy machine.
constexpr double kOperationsPerMs = 5e5;

std::uint64_t operationsOf(double step_budget_ms)
{
  const double operations = std::max(1.0, kOperationsPerMs * step_budget_ms);
  const bool limited = step_budget_ms > 0 && operations < static_cast<double>(SlicedWork::kUnlimited);
  return limited ? static_cast<std::uint64_t>(operations) : SlicedWork::kUnlimited;
}
}  // namespace

SlicedLocalizer::SlicedLocalizer(Process process, double step_budget_ms)
    : process_(std::move(process)), step_(operationsOf(step_budget_ms))
{
}

void SlicedLocalizer::add(Frame frame)
{
  waiting_.push_back(std::move(frame));
  goOn();
}

void SlicedLocalizer::goOn()
{
  left_ = step_ < SlicedWork::kUnlimited - left_ ? left_ + step_ : SlicedWork::kUnlimited;
}

std::optional<SlicedLocalizer::Finished> SlicedLocalizer::next()
{
  const bool hurries = waiting_.size() > kMostWaiting;
  if (!hasWaiting()) left_ = 0;  // later steps do not get what this one did not need
  if (left_ == 0 && !hurries) return std::nullopt;
  if (work_.isDone())
  {
    current_.frame = std::move(waiting_.front());
    waiting_.pop_front();
    work_.begin([this] { current_.estimate = process_(current_.frame); });
  }
  const std::uint64_t left = work_.resume(hurries ? SlicedWork::kUnlimited : left_);
  if (!hurries) left_ = left;
  if (!work_.isDone()) return std::nullopt;
  return std::move(current_);
}
}  // namespace mrpt_ext
