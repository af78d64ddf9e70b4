#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <semaphore>
#include <thread>
#include <utility>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
/// Lets a long computation wait where a slice of its work ends, and go on with the next slice: a search of half a
/// second on a robot that has 50 ms. The computation has a thread of its own for its stack only: it runs while resume()
/// waits for it, never beside it. Slices are measured in operations as the computation itself counts them
/// (work_counter.h), so that each ends at the same point on every machine, and the result does not depend on them.
class SlicedWork : private WorkObserver
{
 public:
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

  SlicedWork() = default;
  /// Work that was begun and is not done is done to its end.
  ~SlicedWork();
  SlicedWork(const SlicedWork&) = delete;
  SlicedWork& operator=(const SlicedWork&) = delete;

  /// The next work, when the one before is done.
  void begin(std::function<void()> work) { work_ = std::move(work); }
  [[nodiscard]] bool isDone() const { return !work_; }
  /// Does so many operations of the work, a few more at most. Returns how many of them were not needed; none while the
  /// work is not done. What the work throws comes from here.
  std::uint64_t resume(std::uint64_t operations);
  /// Processor time [s] of the slices so far that the calling thread did not do itself.
  [[nodiscard]] double cpuSeconds();

 private:
  /// Called within the work.
  void spend(std::uint64_t operations) override;
  void run();
  /// To the caller, from the thread of the work.
  void handOver();

  std::function<void()> work_;  // empty: done
  std::thread thread_;
  std::binary_semaphore go_{0}, paused_{0};
  // Of the thread whose turn it is
  std::uint64_t left_ = 0;                // of the slice
  std::uint64_t mark_ = 0, counted_ = 0;  // by its WorkCounter: at the start of the slice, in the slice
  bool ended_ = false;
  std::exception_ptr error_;
};
}  // namespace mrpt_ext
