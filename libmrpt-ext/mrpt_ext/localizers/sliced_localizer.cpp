#include "mrpt_ext/localizers/sliced_localizer.h"

#include <algorithm>
#include <utility>

namespace mrpt_ext
{
namespace
{
// An operation takes about a nanosecond (work_budget.h); in steps of the recordings up to two, on a busy machine.
constexpr double kOperationsPerMs = 4.5e5;

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
  goOn();
  waiting_.push_back({std::move(frame), steps_});
}

void SlicedLocalizer::goOn()
{
  ++steps_;
  left_ = step_ < SlicedWork::kUnlimited - left_ ? left_ + step_ : SlicedWork::kUnlimited;
}

std::optional<SlicedLocalizer::Finished> SlicedLocalizer::next()
{
  const bool hurries = waiting_.size() > kMostWaiting;
  if (!hasWaiting()) left_ = 0;  // later steps do not get what this one did not need
  if (left_ == 0 && !hurries) return std::nullopt;
  if (work_.isDone())
  {
    current_.frame = std::move(waiting_.front().frame);
    current_step_ = waiting_.front().step;
    waiting_.pop_front();
    work_.begin([this] { current_.estimate = process_(current_.frame); });
  }
  const std::uint64_t left = work_.resume(hurries ? SlicedWork::kUnlimited : left_);
  if (!hurries) left_ = left;
  if (!work_.isDone()) return std::nullopt;
  current_.steps_late = steps_ - current_step_;
  return std::move(current_);
}

std::string reasonWithLateness(const std::string& reason, std::size_t steps_late)
{
  if (steps_late == 0) return reason;
  return reason + "; " + std::to_string(steps_late) + (steps_late == 1 ? " step late" : " steps late");
}
}  // namespace mrpt_ext
