#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "mrpt_ext/geometry/sliced_work.h"
#include "mrpt_ext/localizers/localizer.h"

namespace mrpt_ext
{
/// Makes the steps of a localizer short. Every frame brings the work of one step with it; a frame that takes more goes
/// on in the next steps, and later frames wait for it. The estimates are those of the localizer itself, whatever a step
/// may do: some of them come some frames late. A step of 50 ms is exceeded at the start, by searches of a lost robot,
/// and hardly ever else.
class SlicedLocalizer
{
 public:
  using Process = std::function<Estimate(const Frame&)>;
  struct Finished
  {
    Frame frame;
    Estimate estimate;
    std::size_t steps_late = 0;  ///< that followed the step of the frame; 0: finished in that step
  };
  /// Frames that wait at most. Of a localizer that is too slow for its budget in the long run, steps take longer.
  static constexpr std::size_t kMostWaiting = 250;

  /// `process`: of the localizer. `step_budget_ms`: in counted operations (work_counter.h), so that it is the same on
  /// every machine; 0: no limit.
  SlicedLocalizer(Process process, double step_budget_ms);

  /// A frame, and the work of a step.
  void add(Frame frame);
  /// The work of a step without a frame.
  void goOn();
  /// The next frame that is finished; nothing when no frame waits, or the work of this step is done. Until the next
  /// call the localizer is as this frame left it.
  std::optional<Finished> next();
  /// True while next() has not given all frames.
  [[nodiscard]] bool hasWaiting() const { return !waiting_.empty() || !work_.isDone(); }
  /// Processor time [s] that the calling thread did not spend itself.
  [[nodiscard]] double cpuSeconds() { return work_.cpuSeconds(); }

 private:
  struct Waiting
  {
    Frame frame;
    std::size_t step = 0;  // that brought it
  };

  Process process_;
  std::uint64_t step_;      // operations
  std::uint64_t left_ = 0;  // of this step
  std::size_t steps_ = 0;   // so far
  std::deque<Waiting> waiting_;
  Finished current_;
  std::size_t current_step_ = 0;
  SlicedWork work_;  // last: its destructor ends the work
};

/// What an estimate rests on, and by how many steps it is late, if it is.
[[nodiscard]] std::string reasonWithLateness(const std::string& reason, std::size_t steps_late);
}  // namespace mrpt_ext
