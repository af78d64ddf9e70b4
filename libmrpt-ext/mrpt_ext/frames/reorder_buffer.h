#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// A record with its origin.
struct LoggedRecord
{
  Record record;
  std::optional<std::size_t> step;  ///< index of the action/sensory-frame pair
  std::uint64_t order = 0;          ///< records of the same time keep this order
};

/// Sorts records that arrive nearly in order of time: a record leaves when no earlier one can arrive any more.
class ReorderBuffer
{
 public:
  /// `window` [s]: how much earlier than the newest record a record may be.
  explicit ReorderBuffer(double window) : window_(window) {}

  void push(LoggedRecord record);
  /// The time is `time`: what may leave then, may leave.
  void passTo(double time) { newest_ = std::max(newest_, time); }
  /// The log has ended: everything may leave.
  void close() { closed_ = true; }
  [[nodiscard]] bool canPop() const;
  [[nodiscard]] LoggedRecord pop();
  [[nodiscard]] double newestTime() const { return newest_; }
  /// No record before this time can be pushed any more.
  [[nodiscard]] double settledTime() const { return newest_ - window_; }
  /// True if a record of this time arrives too late to be sorted.
  [[nodiscard]] bool isTooLate(double time) const { return time < settledTime(); }

 private:
  double window_;
  double newest_ = -std::numeric_limits<double>::infinity();
  bool closed_ = false;
  std::uint64_t pushed_ = 0;
  std::vector<LoggedRecord> heap_;
};
}  // namespace mrpt_ext
