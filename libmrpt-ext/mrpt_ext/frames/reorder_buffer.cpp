#include "mrpt_ext/frames/reorder_buffer.h"

#include <algorithm>
#include <tuple>

namespace mrpt_ext
{
namespace
{
/// At the same time, odometry comes before what was measured from there.
auto sortKey(const LoggedRecord& logged)
{
  return std::make_tuple(timeOf(logged.record), !std::holds_alternative<OdometryRecord>(logged.record), logged.order);
}

bool leavesLater(const LoggedRecord& a, const LoggedRecord& b) { return sortKey(a) > sortKey(b); }
}  // namespace

void ReorderBuffer::push(LoggedRecord record)
{
  record.order = pushed_++;
  newest_ = std::max(newest_, timeOf(record.record));
  heap_.push_back(std::move(record));
  std::push_heap(heap_.begin(), heap_.end(), leavesLater);
}

bool ReorderBuffer::canPop() const
{
  return !heap_.empty() && (closed_ || timeOf(heap_.front().record) < settledTime());
}

LoggedRecord ReorderBuffer::pop()
{
  std::pop_heap(heap_.begin(), heap_.end(), leavesLater);
  LoggedRecord record = std::move(heap_.back());
  heap_.pop_back();
  return record;
}
}  // namespace mrpt_ext
