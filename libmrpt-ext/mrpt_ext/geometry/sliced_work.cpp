#include "mrpt_ext/geometry/sliced_work.h"

#include <pthread.h>

#include <algorithm>
#include <ctime>
#include <utility>

namespace mrpt_ext
{
SlicedWork::~SlicedWork()
{
  if (!thread_.joinable()) return;
  left_ = kUnlimited;
  ended_ = true;
  go_.release();
  thread_.join();
}

std::uint64_t SlicedWork::resume(std::uint64_t operations)
{
  if (isDone()) return operations;
  if (!thread_.joinable() && operations == kUnlimited)
  {
    std::exchange(work_, nullptr)();
    return operations;
  }
  left_ = operations;
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  go_.release();
  paused_.acquire();
  WorkCounter::add(counted_);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  return isDone() ? left_ : 0;
}

double SlicedWork::cpuSeconds()
{
  clockid_t clock{};
  timespec t{};
  if (!thread_.joinable() || pthread_getcpuclockid(thread_.native_handle(), &clock) != 0) return 0;
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void SlicedWork::run()
{
  WorkCounter::observeBy(this);
  for (go_.acquire(); !ended_; go_.acquire())
  {
    mark_ = WorkCounter::done();
    try
    {
      work_();
    }
    catch (...)
    {
      error_ = std::current_exception();
    }
    if (ended_) return;
    work_ = nullptr;
    handOver();
  }
}

void SlicedWork::spend(std::uint64_t operations)
{
  left_ -= std::min(left_, operations);
  if (left_ > 0) return;
  handOver();
  go_.acquire();
  mark_ = WorkCounter::done();
}

void SlicedWork::handOver()
{
  counted_ = WorkCounter::done() - mark_;
  paused_.release();
}
}  // namespace mrpt_ext
